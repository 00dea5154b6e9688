#include "scene/shot_tables.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/keys.h"
#include "scene/limits.h"
#include "scene/match_cut.h"
#include "scene/natural_times.h"
#include "scene/scene_tables.h"

namespace twrench::scene {
namespace {

/// Returns the speed in seconds of motion per second of video: a number, or pairs of a time in the
/// shot, in s, and the speed at that time.
SpeedCurve read_speed(TomlTable& table, double length, double otherwise) {
  const std::string place = table.place("speed");
  const auto pairs = table.number_or_pairs("speed");
  if (!pairs) return {{{0, otherwise}}};
  SpeedCurve curve;
  for (const auto& [time, speed] : *pairs) {
    limits::check({0, length}, place, time);
    limits::check(limits::shot_speed, place, speed);
    if (!curve.points.empty() && time <= curve.points.back().time) {
      throw InvalidArgument(place, fmt::format("has a point at {} s after one at {} s", time,
                                               curve.points.back().time));
    }
    curve.points.push_back({time, speed});
  }
  if (curve.points.empty()) throw InvalidArgument(place, "has no points");
  return curve;
}

/// Throws if the shot sets a value that must be the same in the whole film.
void require_of_film(const TomlTable& table, const Scene& shot, const Scene& film) {
  if (table.has("font") || shot.look.transparent != film.look.transparent) {
    throw InvalidArgument(table.place(table.has("font") ? "font" : "background"),
                          "must be the same in the whole film: set it outside of the shots");
  }
}

/// Reads the tables that a shot shares with the scene. Returns the duration of the motion if the
/// shot sets it, otherwise 0.
double read_scene(TomlTable& table, Scene& shot, const Scene& film, MeshFiles& meshes) {
  if (table.has("part") || table.has("body")) shot.body = read_body(table, meshes);
  double duration = 0;
  for (const char* name : field_tables_of_shots) {
    table.table(name, [&](TomlTable& fields) {
      read_fields(fields, name, shot);
      require_of_film(fields, shot, film);
      if (fields.has("duration")) duration = shot.motion.duration;
    });
  }
  return duration;
}

bool shows_one_body(const Scene& scene) {
  return scene.overlay.view == View::wrench && scene.overlay.motion_count() == 1;
}

/// The body and the initial conditions that determine a motion.
struct Start {
  explicit Start(const Scene& scene)
      : inertia(mass_properties(scene.body).inertia),
        omega(scene.motion.omega),
        attitude(scene.motion.attitude),
        wheel(scene.motion.wheel),
        energy_loss_time(scene.motion.energy_loss_time),
        compared_omega(scene.overlay.compare_omega),
        compared_wheel(scene.overlay.compare_wheel) {}
  bool operator==(const Start&) const = default;

  Eigen::Matrix3d inertia;
  Eigen::Vector3d omega;
  std::optional<Eigen::Quaterniond> attitude;
  std::optional<Eigen::Vector3d> wheel;
  std::optional<double> energy_loss_time;
  std::vector<Eigen::Vector3d> compared_omega, compared_wheel;
};

/// Reads shots one after the other.
class ShotReader {
 public:
  ShotReader(const Scene& film, MeshFiles& meshes) : film_(film), meshes_(meshes) {}

  void read(TomlTable& table);

  /// Returns the shots. Each motion lasts until the end of the last shot that shows it, unless the
  /// shot sets its duration.
  std::vector<Shot> finish();

 private:
  /// A motion that one or more shots show.
  struct Shown {
    Start start;
    double end = 0;     ///< Time at which its last shot ended, in s.
    double needed = 0;  ///< Minimum duration, in s.
  };

  double read_transition(TomlTable& table, const std::string& key, double length) const;
  double read_start(TomlTable& table, const Scene& shot, double duration) const;
  bool continues(const Shot& shot) const;
  std::size_t motion_of(const Scene& shot);

  const Scene& film_;
  MeshFiles& meshes_;
  std::vector<Shot> shots_;
  std::vector<Shown> motions_;
  std::vector<std::size_t> motion_of_shot_;
  std::size_t parts_ = 0;  ///< Number of parts in all shots.
};

/// The duration in s of a transition at the shot's start, within its length; 0 if it is not given.
double ShotReader::read_transition(TomlTable& table, const std::string& key, double length) const {
  const auto given = table.value(key, ValueForm::Kind::number);
  const double time = given ? given->get<double>() : 0;
  if (!given || limits::check(limits::shot_transition, table.place(key), time) == 0) return 0;
  if (shots_.empty()) {
    throw InvalidArgument(table.place(key), "must be 0 in the first shot, which follows no other");
  }
  const double room = std::min(length, *shots_.back().scene.length);
  if (time <= room) return time;
  throw InvalidArgument(table.place(key),
                        fmt::format("is {} s, but must be at most {} s, the length of the shorter "
                                    "one of this shot and the previous",
                                    time, room));
}

std::size_t ShotReader::motion_of(const Scene& shot) {
  const Start start(shot);
  const auto found = std::ranges::find(motions_, start, &Shown::start);
  if (found != motions_.end()) return static_cast<std::size_t>(found - motions_.begin());
  motions_.push_back({start});
  return motions_.size() - 1;
}

/// The time in s of the motion, the last in motion_of_shot_, at the start of the shot. A shot that
/// matches the previous one starts within `duration` s.
double ShotReader::read_start(TomlTable& table, const Scene& shot, double duration) const {
  const std::string place = table.place("start");
  if (!table.is_text("start")) {
    const auto start = table.value("start", ValueForm::Kind::number);
    return start ? limits::check(limits::shot_start, place, start->get<double>())
                 : motions_[motion_of_shot_.back()].end;
  }
  const std::string word = table.required_text("start");
  if (word != match_name) {
    throw InvalidArgument(place,
                          fmt::format("is '{}', but must be a number or '{}'", word, match_name));
  }
  if (shots_.empty() || !shows_one_body(shot) || !shows_one_body(shots_.back().scene)) {
    throw InvalidArgument(place, fmt::format("'{}' needs this shot and a previous one to show one "
                                             "body each, in the view 'wrench'",
                                             match_name));
  }
  return match_time(shot, duration, shots_.back());
}

/// Returns whether the shot, the last in motion_of_shot_, continues the motion of the last in
/// shots_ with the same method.
bool ShotReader::continues(const Shot& shot) const {
  if (shots_.empty()) return false;
  const Shot& last = shots_.back();
  const Motion &one = last.scene.motion, &other = shot.scene.motion;
  const double end = last.time_of(*last.scene.length);
  constexpr double round_off = 1e-9;
  return motion_of_shot_.end()[-2] == motion_of_shot_.back() && one.method == other.method &&
         one.control.step == other.control.step &&
         one.control.tolerance == other.control.tolerance &&
         std::abs(shot.start - end) <= round_off * end;
}

void ShotReader::read(TomlTable& table) {
  Shot shot;
  shot.place = table.place("");
  shot.scene = film_;
  const double length = table.required_number("length", limits::shot_length);
  shot.scene.length = length;
  const auto caption = table.value("caption", ValueForm::Kind::text);
  shot.scene.caption = caption ? caption->get<std::string>() : std::string();
  const double duration = read_scene(table, shot.scene, film_, meshes_);
  require_interior(table, shot.scene);
  set_natural_times(shot.scene);
  const double searched = shot.scene.motion.duration;
  shot.scene.motion.duration = duration;
  parts_ += shot.scene.body.parts.size();
  if (parts_ > limits::max_parts_of_shots) {
    throw InvalidArgument(shot.place, fmt::format("the shots have at most {} parts together",
                                                  limits::max_parts_of_shots));
  }
  shot.fade = read_transition(table, "fade", length);
  shot.move = read_transition(table, "move", length);
  if (shot.move > 0 && !(shows_one_body(shot.scene) && shows_one_body(shots_.back().scene))) {
    throw InvalidArgument(table.place("move"),
                          "needs two shots of one body each, in the view 'wrench'");
  }
  shot.speed = read_speed(table, length, shot.scene.film.speed);
  if (shot.speed.fastest() > 0) shot.scene.film.speed = shot.speed.fastest();
  const auto narration = table.value("narration", ValueForm::Kind::text);
  if (narration) shot.narration = meshes_.sound(narration->get<std::string>());
  shot.scene.origins.duration = shot.scene.origins.speed = Origin::scene;
  motion_of_shot_.push_back(motion_of(shot.scene));
  shot.start = read_start(table, shot.scene, searched);
  motions_[motion_of_shot_.back()].end = shot.time_of(length);
  shot.continues = continues(shot);
  shots_.push_back(std::move(shot));
}

std::vector<Shot> ShotReader::finish() {
  std::vector<double> ends;  // of the shots, including transitions to the next
  for (std::size_t i = 0; i < shots_.size(); ++i) {
    const bool last = i + 1 == shots_.size();
    const double after = last ? 0 : std::max(shots_[i + 1].fade, shots_[i + 1].move);
    ends.push_back(shots_[i].time_of(*shots_[i].scene.length + after));
    double& needed = motions_[motion_of_shot_[i]].needed;
    needed = std::max(needed, ends.back());
  }
  for (std::size_t i = 0; i < shots_.size(); ++i) {
    double& duration = shots_[i].scene.motion.duration;
    duration = duration > 0 ? std::max(duration, ends[i]) : motions_[motion_of_shot_[i]].needed;
    if (duration > 0) continue;
    duration = natural_times(shots_[i].scene).duration;  // a motion frozen at its start
  }
  return std::move(shots_);
}

}  // namespace

void read_shots(TomlTable& file, Scene& film, MeshFiles& meshes) {
  ShotReader reader(film, meshes);
  file.tables("shot", [&](TomlTable& table) { reader.read(table); });
  film.shots = reader.finish();
  if (film.shots.size() > limits::max_shots) {
    throw InvalidArgument(film.shots[limits::max_shots].place,
                          fmt::format("a film has at most {} shots", limits::max_shots));
  }
  const bool captioned = std::ranges::any_of(
      film.shots, [](const Shot& shot) { return !shot.scene.caption->empty(); });
  for (Shot& shot : film.shots) {
    if (!captioned) shot.scene.caption.reset();
  }
}

}  // namespace twrench::scene

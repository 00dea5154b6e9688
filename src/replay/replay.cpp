#include "replay/replay.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <twrench/base/error.h>
#include <twrench/motion/exact.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <future>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/enumeration.h"
#include "base/words.h"
#include "check/report/checked_file.h"
#include "check/report/choice.h"
#include "check/report/result.h"
#include "check/verdict/error.h"
#include "check/verdict/flips.h"
#include "recording/motion_of_rows.h"
#include "scene/limits.h"
#include "scene/natural_times.h"
#include "scene/recording_file.h"
#include "scene/shown_recording.h"
#include "system/bytes.h"

namespace twrench::replay {
namespace {

using motion::RecordedMotion;
using recording::Recording;
using scene::Feature;

/// The features that are drawn from the constants of a free motion.
constexpr std::array of_free_motion{Feature::momentum, Feature::plane, Feature::sphere,
                                    Feature::poinsot,  Feature::phase, Feature::forces,
                                    Feature::torques,  Feature::tip,   Feature::tilt};

void require_one_motion(const scene::Scene& scene, const std::string& name) {
  if (!scene.shots.empty()) {
    throw InvalidArgument(name, "the shots of " + scene.name + " have separate motions",
                          "name a scene without shots, or a mesh");
  }
  if (!scene.overlay.compare_omega.empty() || !scene.overlay.compare_wheel.empty()) {
    throw InvalidArgument(name, "it has one start, but motions with others are to be compared",
                          "compare methods, such as exact");
  }
  if (scene.overlay.compare.size() >= scene::limits::max_compared) {
    throw InvalidArgument(name,
                          fmt::format("at most {} motions are drawn side by side, and it is one",
                                      scene::limits::max_compared),
                          "compare fewer methods");
  }
  if (scene.camera.frame == scene::Frame::rotating) {
    throw InvalidArgument(name, "the rotating frame is that of a free motion",
                          "choose the frame space or body");
  }
}

/// Whether the first row has noise that its digits do not explain.
bool is_first_row_noisy(const check::Judgement& judgement) {
  return !judgement.within_digits && (judgement.noise.rate > 0 || judgement.noise.attitude > 0);
}

/// Whether the errors are noise, rather than those of an integrator, which grow: a fit would
/// distribute them over all rows.
bool is_explained_by_noise(const check::Judgement& judgement) {
  constexpr double much = 3;  // the largest of three components, and the error of the fit
  return judgement.within_noise ||
         (judgement.rates && judgement.rates->rms <= much * judgement.noise.rate);
}

/// Compares the recording with the free motion from its first row or, if that has noise or no
/// rates, with the one that fits all rows best; nothing if there is none.
std::optional<check::CheckedFile> judged(const scene::Scene& scene, const Recording& recording,
                                         const recording::Convention& given) try {
  if (!scene.motion.is_rigid()) return std::nullopt;
  check::Problem problem{.inertia = scene::mass_properties(scene.body).inertia};
  problem.omega_time.reset();
  const auto judge = [&] {
    return check::check_files(1, [&](std::size_t) { return recording; }, {}, given, problem, {})
        .files.front();
  };
  check::CheckedFile file = judge();
  if (file.judgement.fit || !is_first_row_noisy(file.judgement)) return file;
  problem.fit = true;
  check::CheckedFile fitted = judge();
  return is_explained_by_noise(fitted.judgement) ? fitted : file;
} catch (const check::CheckError&) {
  return std::nullopt;  // a body at rest, or no free motion
}

/// Whether the body keeps its angular momentum, up to errors.
bool keeps_momentum(const check::Judgement& judgement) {
  constexpr double most = 0.1;
  return judgement.momentum_drift.value_or(0) <= most &&
         judgement.direction_drift.value_or(0) <= most;
}

/// Whether the body moves as a free one, up to errors.
bool follows(const std::optional<check::CheckedFile>& file) {
  if (!file) return false;
  using enum check::Finding;
  switch (check::verdict(*file).finding) {
    case exact:
    case noise:
    case start:
    case integration:
      return keeps_momentum(file->judgement);
    case convention:
    case body:
    case law:
    case inconsistent:
      return false;
  }
  return false;
}

std::string digest_of(const RecordedMotion& motion) {
  std::vector<std::uint8_t> bytes;
  const auto add = [&](std::span<const double> numbers) {
    const auto* const first = reinterpret_cast<const std::uint8_t*>(numbers.data());
    bytes.insert(bytes.end(), first, first + numbers.size_bytes());
  };
  bytes.reserve(8 * sizeof(double) * motion.instants().size());
  for (const RecordedMotion::Instant& instant : motion.instants()) {
    add({&instant.t, 1});
    add({instant.X.coeffs().data(), 4});
    add({instant.omega.data(), 3});
  }
  return system::sha256_hex(bytes);
}

/// The flips of a body that would turn over in free motion. Of others, the component of omega along
/// the intermediate axis changes its sign as they wobble.
std::vector<double> flips_of(const RecordedMotion& motion, const check::Reference& reference) {
  const auto flips = motion::ExactMotion(reference.body).flips();
  if (!flips || !flips->turns_over()) return {};
  check::FlipFinder finder(reference);
  for (const RecordedMotion::Instant& instant : motion.instants()) {
    finder.add(instant.t, instant.omega);
  }
  std::vector<double> times;
  for (const check::SignChange& change : finder.finish()) times.push_back(change.t);
  return times;
}

/// Removes what needs a free motion, with a note. Throws InvalidArgument if nothing would be left.
void leave_out(scene::Scene& scene, const std::string& name, const std::string& why,
               std::vector<std::string>& notes) {
  if (scene.overlay.view != scene::View::wrench) {
    throw InvalidArgument(
        name,
        fmt::format("the view {} is that of a free motion, but {}",
                    enumerator_name(scene.overlay.view), why),
        "name the body by a scene, a mesh or its inertia, or show the view wrench");
  }
  std::vector<std::string> names;
  for (const Feature feature : of_free_motion) {
    if (scene.overlay.show.erase(feature) > 0) names.emplace_back(enumerator_name(feature));
  }
  if (names.empty()) return;
  notes.push_back(fmt::format("{}, so these are left out: {}", why, fmt::join(names, ", ")));
}

/// Draws a box for a body that is not known.
void show_unknown_body(scene::Scene& scene, const std::string& name) {
  if (!scene.overlay.compare.empty()) {
    throw InvalidArgument(name, "the body is not given, so no motion can be compared with it",
                          "name a scene or a mesh, or give its inertia");
  }
  scene::Body box;
  box.inertia = Eigen::Vector3d(2, 3, 4.5).asDiagonal();
  scene::replace_body(scene, std::move(box));
  scene.name = std::filesystem::path(name).stem().string();
}

/// The convention in which a recording is shown and compared.
recording::Convention chosen(const scene::Scene& scene, const Recording& recording,
                             const recording::Convention& given, Body body) {
  std::optional<check::Problem> problem;
  if (body == Body::known) {
    problem = check::Problem{.inertia = scene::mass_properties(scene.body).inertia};
  }
  recording::Convention convention = check::choose_convention(recording, given, problem);
  if (problem || !has_momentum(convention)) return convention;
  throw InvalidArgument(recording.name(), "it has the angular momentum instead of rates",
                        "name the body: a scene, a mesh or its inertia");
}

std::string why_not_free(const std::string& name, Body body,
                         const std::optional<check::CheckedFile>& file) {
  switch (body) {
    case Body::unknown:
      return "the body is not given, by a scene, a mesh or its inertia";
    case Body::known:
      break;
  }
  if (file) return name + " does not follow a free motion of this body";
  return fmt::format("no free motion of this body can be fitted to {}", name);
}

/// Names the noise, as far as there is any.
std::string noise_text(const recording::RowNoise& noise) {
  std::vector<std::string> parts;
  if (noise.attitude) {
    parts.push_back(
        fmt::format("{:.2g} degrees in the attitudes", *noise.attitude * 180 / std::numbers::pi));
  }
  if (noise.rates) parts.push_back(fmt::format("{:.2g} rad/s in the rates", *noise.rates));
  return fmt::format("{}", fmt::join(parts, " and "));
}

/// Whether a film shows the noise: the body or the arrow of omega would tremble.
bool is_noise_visible(const recording::MotionOfRows& shown) {
  constexpr double least_angle = 3.5e-3;  // rad: a pixel at the edge of a large body
  constexpr double least_share = 0.02;    // of omega
  const recording::RowNoise& noise = shown.noise;
  if (noise.attitude && *noise.attitude > least_angle) return true;
  const std::vector<RecordedMotion::Instant>& rows = shown.motion.instants();
  double squares = 0;
  for (const RecordedMotion::Instant& row : rows) squares += row.omega.squaredNorm();
  const double speed = std::sqrt(squares / static_cast<double>(rows.size()));
  if (noise.rates) return *noise.rates > least_share * speed;
  // Rates are differences of attitudes.
  const double step = shown.motion.duration() / static_cast<double>(rows.size() - 1);
  return noise.attitude && *noise.attitude / step > least_share * speed;
}

std::string note_on_noise(const recording::MotionOfRows& shown, const std::string& file,
                          recording::Smoothing smoothing) {
  const std::string noise = noise_text(shown.noise);
  switch (smoothing) {
    case recording::Smoothing::none:
      if (!is_noise_visible(shown)) return "";
      return fmt::format("{} has noise of {}, which can be seen: {} removes it", file, noise,
                         argument("smooth"));
    case recording::Smoothing::within_noise:
      if (noise.empty()) {
        return fmt::format(
            "{} has no noise that is independent from row to row, so its rows are "
            "shown as they are",
            file);
      }
      return fmt::format("{} is smoothed within its noise: {}", file, noise);
  }
  return "";
}

std::vector<std::string> notes_on(const recording::MotionOfRows& shown, const Recording& recording,
                                  recording::Smoothing smoothing) {
  const std::string& file = recording.name();
  std::vector<std::string> notes;
  if (!shown.left_out.empty()) {
    notes.push_back(fmt::format("left out: {}, where numbers are missing", shown.left_out));
  }
  if (!shown.has_attitude) {
    notes.push_back(fmt::format(
        "{} has no attitude: it is the integral of the rates, from the scene's attitude, with an "
        "estimated error of {:.2g} degrees at the end",
        file, shown.drift * 180 / std::numbers::pi));
  }
  if (shown.gaps > 0) {
    notes.push_back(
        fmt::format("{} has {} gap{} of more than four intervals, in which the body is "
                    "held",
                    file, shown.gaps, shown.gaps == 1 ? "" : "s"));
  }
  if (std::string note = note_on_noise(shown, file, smoothing); !note.empty()) {
    notes.push_back(std::move(note));
  }
  return notes;
}

/// Sets the start of the free motion: that of the first row, or the fitted one.
void set_start(scene::Motion& motion, const std::optional<check::CheckedFile>& file,
               const RecordedMotion& recorded, bool has_attitude) {
  motion.omega = recorded.instants().front().omega;
  Eigen::Quaterniond X(recorded.instants().front().X);
  if (file && file->judgement.fit) {
    const check::Reference& fitted = file->judgement.fit->reference;
    motion.omega = fitted.body.omega();
    if (has_attitude) X = Eigen::Quaterniond(fitted.frame);
  }
  motion.attitude = X.normalized();
}

/// Reads the rows of a file on another thread, if one can be started, while it is compared with the
/// free motion.
std::future<recording::MotionOfRows> read_rows(const Recording& recording,
                                               const recording::Convention& convention,
                                               const Eigen::Quaterniond& start,
                                               recording::Smoothing smoothing) {
  if (recording.path().empty()) {
    return std::async(std::launch::deferred, [=] {
      return recording::motion_of_rows(recording, convention, start, smoothing);
    });
  }
  return std::async([=, file = recording.reopened()] {
    return recording::motion_of_rows(file, convention, start, smoothing);
  });
}

/// Sets Motion::recording and the initial condition.
void play(scene::Scene& scene, const Recording& recording, const recording::Convention& given,
          Body body, recording::Smoothing smoothing) {
  const std::string& name = recording.name();
  require_one_motion(scene, name);
  switch (body) {
    case Body::known:
      break;
    case Body::unknown:
      show_unknown_body(scene, name);
      break;
  }
  const auto start = scene.motion.attitude.value_or(Eigen::Quaterniond::Identity());
  auto rows = read_rows(recording, chosen(scene, recording, given, body), start, smoothing);
  std::optional<check::CheckedFile> file;
  if (body == Body::known) file = judged(scene, recording, given);
  recording::MotionOfRows shown = rows.get();
  set_start(scene.motion, file, shown.motion, shown.has_attitude);

  std::vector<std::string> notes = notes_on(shown, recording, smoothing);
  if (!follows(file)) leave_out(scene, name, why_not_free(name, body, file), notes);
  std::vector<double> flips;
  if (file) flips = flips_of(shown.motion, file->judgement.reference);
  const std::string digest = digest_of(shown.motion);
  scene.motion.recording = std::make_shared<const scene::ShownRecording>(
      scene::ShownRecording{.file = name,
                            .path = recording.path(),
                            .motion = std::move(shown.motion),
                            .flip_times = std::move(flips),
                            .sha256 = digest,
                            .drift = shown.drift,
                            .has_body = body == Body::known,
                            .verdict = file ? check::verdict(*file).text : "",
                            .notes = std::move(notes)});
  std::vector<std::string>& compared = scene.overlay.compare;
  if (!compared.empty()) compared.insert(compared.begin(), scene::recorded_name);
}

}  // namespace

void show_recording(scene::Scene& scene, const Recording& recording,
                    const recording::Convention& given, Body body, recording::Smoothing smoothing) {
  play(scene, recording, given, body, smoothing);
  scene.motion.recording_file = nullptr;
  if (scene.origins.title != scene::Origin::user) {
    scene.title = std::filesystem::path(recording.name()).filename().string();
  }
  for (const auto member : scene::all_origins) {
    scene::Origin& origin = scene.origins.*member;
    if (origin == scene::Origin::scene) origin = scene::Origin::none;
  }
}

void show_own_recording(scene::Scene& scene) {
  const std::shared_ptr<const scene::RecordingFile> own = scene.motion.recording_file;
  const Recording whole(own->path);
  play(scene, whole.between({own->from, own->to}), own->convention, Body::known,
       own->smooth ? recording::Smoothing::within_noise : recording::Smoothing::none);
}

}  // namespace twrench::replay

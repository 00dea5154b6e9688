#include "scene/scene.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "base/enumeration.h"
#include "scene/limits.h"
#include "scene/phrase.h"
#include "scene/recording_file.h"
#include "scene/shown_recording.h"

namespace twrench::scene {
namespace {

static_assert(std::ranges::all_of(enumerators<View>, [](View view) {
  return view == View::wrench || view == View::quad || inset_index(view) < insets.size();
}));

std::vector<body::Part> equimomental_parts(const Eigen::Matrix3d& inertia, Equimomental form) {
  switch (form) {
    case Equimomental::box:
      return {body::equimomental_box(inertia)};
    case Equimomental::ellipsoid:
      return {body::equimomental_ellipsoid(inertia)};
    case Equimomental::cross:
      break;
  }
  const auto cross = body::equimomental_cross(inertia);
  return {cross.begin(), cross.end()};
}

std::string remedy_for_frame_count(bool too_many, bool one_motion) {
  if (one_motion) {
    return too_many ? "take a greater speed, a lower frame rate or a shorter duration"
                    : "take a smaller speed, a higher frame rate or a longer duration";
  }
  return too_many ? "take shorter shots or a lower frame rate"
                  : "take longer shots or a higher frame rate";
}

}  // namespace

std::size_t Overlay::motion_count() const {
  return std::max({compare.size(), compare_omega.size(), compare_wheel.size(), std::size_t{1}});
}

double Scene::video_length() const {
  if (length) return *length;
  if (shots.empty()) return motion.duration / film.speed;
  double sum = 0;
  for (const Shot& shot : shots) sum += shot.scene.video_length();
  return sum;
}

int Scene::frame_count() const {
  const double frames = shots.empty() ? std::round(motion.duration * film.fps / film.speed)
                                      : std::round(video_length() * film.fps);
  if (frames < 1.0 || frames > limits::max_frames) {
    throw OutOfRange(
        "film",
        fmt::format("it would have {} frames, but must have 1 to {}", frames, limits::max_frames),
        {frames, 1, limits::max_frames}, remedy_for_frame_count(frames > 1, shots.empty()));
  }
  return static_cast<int>(frames);
}

std::vector<int> first_frames(const Scene& film) {
  std::vector<int> frames{0};
  double end = 0;
  for (const Shot& shot : film.shots) {
    end += shot.scene.video_length();
    frames.push_back(static_cast<int>(std::lround(end * film.film.fps)));
  }
  return frames;
}

void set_background(Look& look, const std::string& text, const std::string& what) {
  look.transparent = text == transparent_name;
  look.background.reset();
  if (!look.transparent) look.background = parse_color(text, what);
}

body::MassProperties mass_properties(const Body& body) {
  if (!body.inertia) return body::mass_properties(body.parts);
  const body::PrincipalAxes principal = body::principal_axes(*body.inertia);
  double mass = body.parts.empty() ? std::numeric_limits<double>::quiet_NaN() : 0.0;
  for (const body::Part& part : body.parts) mass += part.density * body::volume(part.shape);
  return {mass, Eigen::Vector3d::Zero(), *body.inertia, principal.moments, principal.axes};
}

motion::FreeBody free_body(const Scene& scene) {
  const Motion& given = scene.motion;
  motion::Interior interior;
  if (given.wheel) interior.wheel = *given.wheel;
  if (given.energy_loss_time) interior.energy_loss_time = *given.energy_loss_time;
  Eigen::Matrix3d start = Eigen::Matrix3d::Identity();
  if (given.attitude) start = given.attitude->toRotationMatrix();
  return {mass_properties(scene.body).inertia, given.omega, start, interior};
}

std::vector<motion::FreeBody> shown_bodies(const Scene& scene) {
  const motion::FreeBody own = free_body(scene);
  std::vector<motion::FreeBody> bodies;
  for (const Eigen::Vector3d& omega : scene.overlay.compare_omega) {
    bodies.push_back(own.with_omega(omega));
  }
  motion::Interior interior = own.interior();
  for (const Eigen::Vector3d& wheel : scene.overlay.compare_wheel) {
    interior.wheel = wheel;
    bodies.emplace_back(own.inertia(), own.omega(), own.attitude(), interior);
  }
  if (bodies.empty()) bodies.push_back(own);
  return bodies;
}

double fastest_rate(const motion::FreeBody& body) {
  const double doubled_energy = body.omega().dot(body.inertia() * body.omega());
  const double lost = body.energy_loss() * body.body_momentum().stableNorm();
  return std::sqrt(doubled_energy / body.principal().moments[0]) * (1 + lost);
}

std::vector<body::Part> visible_parts(const Body& body) {
  if (body.inertia) return body.parts.empty() ? massive_parts(body) : body.parts;
  const Eigen::Vector3d centre = body::mass_properties(body.parts).centre_of_mass;
  std::vector<body::Part> parts = body.parts;
  for (body::Part& part : parts) part.position -= centre;
  return parts;
}

std::vector<body::Part> massive_parts(const Body& body) {
  return body.inertia ? equimomental_parts(*body.inertia, body.drawn_as) : visible_parts(body);
}

body::Part equal_ellipsoid(const Body& body) {
  const body::MassProperties properties = mass_properties(body);
  body::Part part = body::equimomental_ellipsoid(properties.inertia);
  const double mass = part.density * body::volume(part.shape);
  if (!std::isnan(properties.mass)) {
    // The moments are proportional to the mass and to the squares of the radii.
    auto& ellipsoid = std::get<body::Ellipsoid>(part.shape);
    ellipsoid.radii *= std::sqrt(mass / properties.mass);
    part.density = properties.mass / body::volume(part.shape);
  }
  return part;
}

PartDescription description(const Body& body, std::size_t part) {
  return part < body.descriptions.size() ? body.descriptions[part] : PartDescription{};
}

std::vector<std::string> mesh_notes(const Body& body) {
  std::set<std::string> notes;
  for (const PartDescription& part : body.descriptions) {
    const std::string name = part.mesh ? part.mesh->file : "mesh";
    for (const std::string& note : part.notes) notes.insert(name + ": " + note);
  }
  return {notes.begin(), notes.end()};
}

std::vector<std::string> mesh_notes(const Scene& scene) {
  const std::vector<std::string> own = mesh_notes(scene.body);
  std::set<std::string> notes(own.begin(), own.end());
  for (const Shot& shot : scene.shots) {
    for (std::string& note : mesh_notes(shot.scene)) notes.insert(std::move(note));
  }
  return {notes.begin(), notes.end()};
}

std::optional<std::string> unreal_moments_note(const std::string& of,
                                               const Eigen::Matrix3d& inertia) {
  constexpr double round_off = 1e-12;
  const Eigen::Vector3d moments = body::principal_axes(inertia).moments;
  if (2.0 * moments[2] <= moments.sum() * (1.0 + round_off)) return std::nullopt;
  return fmt::format(
      "{}: moments {:.10g}, {:.10g} and {:.10g}: no real body has them: one exceeds the sum of the "
      "other two",
      of, moments[0], moments[1], moments[2]);
}

std::vector<std::filesystem::path> input_files(const Scene& scene) {
  std::vector<std::filesystem::path> files{scene.overlay.font};
  for (const PartDescription& part : scene.body.descriptions) {
    if (!part.mesh || part.mesh->path.empty()) continue;
    files.push_back(part.mesh->path);
    files.insert(files.end(), part.mesh->others.begin(), part.mesh->others.end());
  }
  if (scene.film.audio.is_given()) files.push_back(scene.film.audio.path);
  const ShownRecording* const recording = scene.motion.recording.get();
  if (scene.motion.recording_file) files.push_back(scene.motion.recording_file->path);
  if (recording != nullptr && !recording->path.empty()) files.push_back(recording->path);
  for (const Shot& shot : scene.shots) {
    if (shot.narration.is_given()) files.push_back(shot.narration.path);
    const std::vector<std::filesystem::path> more = input_files(shot.scene);
    files.insert(files.end(), more.begin(), more.end());
  }
  return files;
}

namespace {

std::string name_of_part(const Body& body, std::size_t part, Language language) {
  if (body.inertia && body.drawn_as == Equimomental::cross) {
    constexpr Phrase cross{"cross", "kors"}, heavy{"heavy discs", "tunge skiver"},
        light{"light discs", "lette skiver"};
    static constexpr std::array names{cross, cross, cross, heavy, heavy, light, light};
    return names.at(part).in(language);
  }
  const std::string given = body.inertia ? std::string() : description(body, part).name;
  return given.empty() ? Phrase("part {}", "del {}").in(language, part + 1) : given;
}

}  // namespace

std::vector<PartGroup> part_groups(const Body& body, Language language) {
  std::vector<PartGroup> groups;
  for (std::size_t i = 0; i < massive_parts(body).size(); ++i) {
    const std::string name = name_of_part(body, i, language);
    auto group = std::ranges::find(groups, name, &PartGroup::name);
    if (group == groups.end()) group = groups.insert(groups.end(), {name, {}});
    group->parts.push_back(i);
  }
  return groups;
}

}  // namespace twrench::scene

#include "interchange/export.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/words.h"
#include "interchange/aem.h"
#include "interchange/blender.h"
#include "interchange/gltf_scene.h"
#include "scene/shown_recording.h"

namespace twrench::interchange {
namespace {

constexpr const char* program = "twrench " TWRENCH_VERSION;

/// Returns a note if the clock of a player cannot be as exact as the keys of the animation.
std::vector<std::string> notes_on_clocks(const scene::Scene& scene,
                                         const AnimationOptions& animation) {
  const auto end = static_cast<float>(scene.motion.duration / animation.speed);
  const double spacing = std::nextafter(end, std::numeric_limits<float>::infinity()) - end;
  const double angle = scene.motion.omega.norm() * animation.speed * spacing / 2;
  if (angle <= animation.max_angle) return {};
  return {fmt::format(
      "a player that keeps the time as a float32 number is off by up to {:.2g} rad at {:.6g} s, "
      "where these are {:.2g} s apart",
      angle, end, spacing)};
}

/// Returns the seconds of motion per second of the animation. The default is 1, or the film's speed
/// if the motion is too fast or too slow to be watched.
double animation_speed(const ExportOptions& options, const scene::Scene& scene) {
  if (options.speed) return *options.speed;
  constexpr double slowest = 0.01, fastest = 100;  // film speeds close enough to real time
  const double speed = scene.film.speed;
  return speed >= slowest && speed <= fastest ? 1 : speed;
}

/// Throws InvalidArgument if the motion has gaps.
AnimationOptions animation_of(const ExportOptions& options, const scene::Scene& scene) {
  if (const auto& recording = scene.motion.recording; recording && recording->motion.has_gaps()) {
    throw InvalidArgument(recording->file, "it has gaps, across which no animation can interpolate",
                          fmt::format("leave them out by {} and {}, or write .csv",
                                      argument("from"), argument("to")));
  }
  return {.max_angle = options.max_angle, .speed = animation_speed(options, scene)};
}

std::vector<std::string> write_gltf(const ExportOptions& options, const scene::Scene& scene,
                                    const Write& write) {
  const AnimationOptions animation = animation_of(options, scene);
  gltf_scene(scene, animation, program).write_glb(write);
  return notes_on_clocks(scene, animation);
}

std::vector<std::string> write_blender(const ExportOptions& options, const scene::Scene& scene,
                                       const Write& write) {
  write_blender_script(scene, animation_of(options, scene), program, write);
  return {};
}

std::vector<std::string> write_attitude_ephemeris(const ExportOptions& options,
                                                  const scene::Scene& scene, const Write& write) {
  const RegularTimes times(scene);
  write_aem(scene, parse_epoch(options.epoch, argument("epoch")), program, times.size(), times,
            write);
  return {};
}

std::vector<std::string> notes_of(std::string note) {
  if (note.empty()) return {};
  return {std::move(note)};
}

constexpr std::array<ExportFormat, 6> formats{
    {{"glb", "glTF 2.0, an animated model", write_gltf},
     {"py", "Python script that animates an object in Blender", write_blender},
     {"aem", "CCSDS attitude ephemeris message", write_attitude_ephemeris},
     {"csv", "as simulate writes it",
      [](const ExportOptions&, const scene::Scene& scene, const Write& write) {
        return notes_of(write_trajectory(write, scene, "csv", {}));
      }},
     {"json", "as simulate writes it",
      [](const ExportOptions&, const scene::Scene& scene, const Write& write) {
        return notes_of(write_trajectory(write, scene, "json", {}));
      }},
     {"npz", "NumPy's arrays, as simulate writes them",
      [](const ExportOptions&, const scene::Scene& scene, const Write& write) {
        return notes_of(write_trajectory(write, scene, "npz", {}));
      }}}};

}  // namespace

std::span<const ExportFormat> export_formats() { return formats; }

const ExportFormat& export_format(const system::OutputFormat& format) {
  return *std::ranges::find(formats, format.name, &ExportFormat::name);
}

}  // namespace twrench::interchange

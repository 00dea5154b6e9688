#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "interchange/key_times.h"
#include "interchange/samples.h"
#include "scene/limits.h"
#include "scene/scene.h"
#include "system/output.h"

namespace twrench::interchange {

/// Options of an export to other programs.
struct ExportOptions {
  /// Bound in rad for the angle between the animation of .glb or .py, at any instant, and the
  /// exact motion.
  double max_angle = 1e-4;
  /// Seconds of motion per second of that animation. If not given it is 1, or the film's speed if
  /// the motion is too fast or too slow to be watched.
  std::optional<double> speed;
  /// Date and time of t = 0 in .aem, TAI.
  std::string epoch = "2026-01-01T00:00:00";
};

/// The allowed values of ExportOptions::max_angle.
inline constexpr scene::limits::Limit max_angle_limit{least_max_angle, scene::limits::huge,
                                                      "the limit of float32 numbers"};

/// An export format, which system::exported_motion has under the same name.
struct ExportFormat {
  const char* name;
  /// Description of the format.
  const char* what;
  /// Writes a motion. Returns notes on its accuracy, one line each.
  std::vector<std::string> (*write)(const ExportOptions& options, const scene::Scene& scene,
                                    const Write& write);
};

/// Returns all formats.
std::span<const ExportFormat> export_formats();

/// Returns how a format of system::exported_motion is written.
const ExportFormat& export_format(const system::OutputFormat& format);

}  // namespace twrench::interchange

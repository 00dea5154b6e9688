#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "motion/recorded_motion.h"

namespace twrench::scene {

/// The name that a recorded motion has beside the methods that compute motions.
inline constexpr const char* recorded_name = "recorded";

/// A recorded motion that a scene shows instead of a computed one.
struct ShownRecording {
  /// The file as it was given, or the name of a recording in memory.
  std::string file;
  /// The path from which it was read; empty if it was in memory.
  std::filesystem::path path;
  motion::RecordedMotion motion;
  /// The times in s at which the recorded body turned over.
  std::vector<double> flip_times;
  /// SHA-256 of the times, attitudes and rates, in hexadecimal digits.
  std::string sha256;
  /// Estimated error in rad of the last attitude, if the attitudes are integrals of the rates.
  double drift = 0;
  /// Whether its body is that of the scene.
  bool has_body = true;
  /// How the recording follows the exact motion of a free body, in one line; empty if it was not
  /// compared.
  std::string verdict = {};
  /// Notes on features that are not shown and on values that were filled in, one line each.
  std::vector<std::string> notes = {};
};

}  // namespace twrench::scene

#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "check/verdict/problem.h"
#include "recording/conventions/convention.h"

namespace twrench::check {

/// A file with an exact motion, and the convention in which it is read.
struct RandomRecording {
  std::string text;                   ///< CSV
  recording::Convention told, right;  ///< in which it is read at first, and was written
  Problem problem;
  std::string description;
};

/// The bodies whose recordings are drawn.
enum class RecordedBody { t_wrench, nearly_symmetric, toutatis, any };

/// The mistakes of a single kind, by name; the numbers are exact otherwise.
const std::vector<std::string>& single_mistakes();

/// A motion of the body from a random start with that mistake.
RandomRecording recording_with(std::string_view mistake, RecordedBody body, std::uint32_t seed,
                               std::uint32_t number);

/// A motion of any body in a random convention, read in another.
RandomRecording random_recording(std::uint32_t seed, std::uint32_t number);

/// Writes the recording into the folder, checks it, and returns the fault of the verdict, or an
/// empty text if the verdict is right: the file follows the motion as it is read, or in all
/// proposed readings, and there are at most two of these.
std::string fault_of_verdict(const RandomRecording& recording, const std::filesystem::path& folder);

}  // namespace twrench::check

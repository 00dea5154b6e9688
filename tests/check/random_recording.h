#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "check/conventions/convention.h"
#include "check/verdict/problem.h"

namespace twrench::check {

/// A file with an exact motion, and how it is told to be read.
struct RandomRecording {
  std::string text;        ///< CSV
  Convention told, right;  ///< how it is read at first, and how it was written
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

/// A motion of any body in a random convention, told to be in another.
RandomRecording random_recording(std::uint32_t seed, std::uint32_t number);

/// What is wrong with the verdict on the recording, which is written into the folder; empty if it
/// is right: the file follows the motion as it is read, or in all readings that are proposed, of
/// which there are at most two.
std::string fault_of_verdict(const RandomRecording& recording, const std::filesystem::path& folder);

}  // namespace twrench::check

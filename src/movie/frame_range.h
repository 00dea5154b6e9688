#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twrench {

/// The most frames that a film can have: two days at 60 a second. Bounds what input can allocate.
constexpr int max_frame_count = 10'000'000;

/// The frames that a RANGE selects, ascending, each once. RANGE is `a`, `a-b` (both included) or
/// `a-b:step`, several with commas between; numbers are those of the film's frames, 0 to
/// frame_count - 1.
/// Throws UsageError, naming the part that is wrong and what is allowed.
std::vector<int> parse_frame_range(std::string_view range, int frame_count);

/// Throws as parse_frame_range, and takes no time for the frames themselves.
void check_frame_range(std::string_view range, int frame_count);

/// The RANGE that names exactly these ascending frames: "0-3,7".
std::string format_frame_range(std::span<const int> frames);

/// The same for a message: of many runs the first, and how many frames there are in all.
std::string brief_frame_range(std::span<const int> frames);

}  // namespace twrench

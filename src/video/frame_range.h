#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twrench::video {

/// The maximum number of frames of a video, two days at 60 per second. Limits the memory that input
/// can request.
constexpr int max_frame_count = 10'000'000;

/// Returns the frames that a RANGE selects, ascending and without repetition. RANGE is `a`, `a-b`
/// (both included) or `a-b:step`, several separated by commas; frame numbers are less than
/// frame_count. Throws InvalidArgument with the invalid part and the allowed values.
std::vector<int> parse_frame_range(std::string_view range, int frame_count);

/// Throws as parse_frame_range() does, without listing the frames.
void check_frame_range(std::string_view range, int frame_count);

/// Returns the RANGE of exactly these ascending frames, for example "0-3,7".
std::string format_frame_range(std::span<const int> frames);

/// The same for messages: if there are many runs, the first ones and the total number of frames.
std::string brief_frame_range(std::span<const int> frames);

}  // namespace twrench::video

#pragma once

#include <cstdint>
#include <span>

namespace twrench {

/// Whether the bytes can be a whole PNG file, to be asked before it is decoded: its parts lie
/// within it, and it is long enough for the size that it says. A decoder believes both, and
/// allocates accordingly; so a few bytes could ask for gigabytes.
bool can_be_whole_png(std::span<const std::uint8_t> file);

}  // namespace twrench

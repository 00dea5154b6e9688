#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace twrench {

/// What a PNG file says of its pixels before they come.
struct PngHeader {
  std::uint64_t width, height;
  bool has_alpha;  ///< a channel of it, or a colour or palette entries that are transparent
};

/// Whether the bytes can be a whole PNG file, to be asked before it is decoded: its parts lie
/// within it, and it is long enough for the size that it says. A decoder believes both, and
/// allocates accordingly; so a few bytes could ask for gigabytes.
bool can_be_whole_png(std::span<const std::uint8_t> file);

/// The header of a file that can be whole.
PngHeader png_header(std::span<const std::uint8_t> file);

/// What the checksums of a file that can be whole tell of damage: its chunks' and that of all the
/// data, which stb_image leaves alone. Empty where they are right: "the checksum of its chunk IDAT
/// is wrong".
std::string find_png_damage(std::span<const std::uint8_t> file);

}  // namespace twrench

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "image/image.h"

namespace twrench::image {

/// Decodes a PNG file of the kind that encode_png() and many other programs write: 8 bits of RGB or
/// RGBA, row after row, without filters that need more than one neighbour. Returns nothing for any
/// other file and for a damaged one; use libspng for these. ISA-L inflates the data once and to
/// their end; libspng takes as long as zlib and does not read the end. `memory` is used for the
/// pixels.
std::optional<Image> decode_plain_png(std::span<const std::uint8_t> file,
                                      std::vector<std::uint8_t> memory);

}  // namespace twrench::image

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "image/image.h"

namespace twrench::image {

/// Returns the image in a PNG file of the kind that encode_png() and many other programs write: 8
/// bits of RGB or RGBA, row after row, without a filter that needs more than one neighbour. Nothing
/// for any other file, and for whatever is not as it should be; libspng is then the judge. The data
/// are inflated once, by ISA-L, where libspng takes zlib's time and does not read them to their
/// end. `memory` is used for the pixels.
std::optional<Image> decode_plain_png(std::span<const std::uint8_t> file,
                                      std::vector<std::uint8_t> memory);

}  // namespace twrench::image

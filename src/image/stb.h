#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "image/image.h"

/// stb_image_write, which is compiled in one place.
namespace twrench::image::stb {

/// Filters a row of 8-bit pixels by PNG's Sub, which looks at no other row (PNG
/// specification, 9.2). `filtered` has room for a byte more than the row: which filter it was comes
/// first.
void filter_row(std::span<const std::uint8_t> row, int channels, std::span<std::uint8_t> filtered);

/// Returns the image, without its alpha, as a JPEG file of that quality, 1 to 100.
std::vector<std::uint8_t> jpeg(const Image& image, int quality);

}  // namespace twrench::image::stb

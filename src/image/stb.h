#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "image/image.h"

/// stb_image_write, which is compiled in one place.
namespace twrench::image::stb {

/// Filters a row of 8-bit pixels with PNG's filter Sub, which needs no other row (PNG
/// specification, 9.2). `filtered` must be one byte longer than the row; its first byte is the type
/// of the filter.
void filter_row(std::span<const std::uint8_t> row, int channels, std::span<std::uint8_t> filtered);

/// Returns the image, without its alpha, as a JPEG file of the given quality, 1 to 100.
std::vector<std::uint8_t> jpeg(const Image& image, int quality);

}  // namespace twrench::image::stb

#pragma once

#include <cstdint>
#include <span>

/// stb_image_write, which is compiled in one place, in the words that row_bands.cpp needs.
namespace twrench::image::stb {

/// Filters a row of 8-bit pixels by PNG's Sub, which looks at no other row (PNG
/// specification, 9.2). `filtered` has room for a byte more than the row: which filter it was comes
/// first.
void filter_row(std::span<const std::uint8_t> row, int channels, std::span<std::uint8_t> filtered);

}  // namespace twrench::image::stb

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

/// stb_image and stb_image_write, which are compiled in one place, in the words that png.cpp needs.
namespace twrench::stb {

struct Free {
  void operator()(void* memory) const noexcept;
};
using Memory = std::unique_ptr<std::uint8_t, Free>;

/// Filters rows of 8-bit pixels as PNG has them, each without regard to others and then one byte
/// longer, and gives them to `take`, which throws nothing. stb_image_write filters only what it
/// writes: the file that it makes of the rows is dropped. Any number of threads at once. Throws
/// std::bad_alloc.
void filter_rows(const std::uint8_t* pixels, int width, int rows, int channels,
                 const std::function<void(std::span<std::uint8_t>)>& take);

struct Pixels {
  Memory data;  ///< null when `failure` says why
  int width = 0;
  int height = 0;
  int channels = 0;  ///< 3 or 4
  std::string failure;
};

/// The pixels of a PNG file whose sides are at most `max_side`. Any number of threads at once.
Pixels decode_png(std::span<const std::uint8_t> file, int max_side);

}  // namespace twrench::stb

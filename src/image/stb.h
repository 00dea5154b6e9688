#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

/// stb_image and stb_image_write, which are compiled in one place, in the words that png.cpp needs.
namespace twrench::stb {

struct Free {
  void operator()(void* memory) const noexcept;
};
using Memory = std::unique_ptr<std::uint8_t, Free>;

struct Bytes {
  Memory data;  ///< null when memory ran out
  std::size_t size = 0;
};

/// The PNG file of 8-bit pixels, rows from the top without padding. Any number of threads at once.
Bytes encode_png(const std::uint8_t* pixels, int width, int height, int channels);

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

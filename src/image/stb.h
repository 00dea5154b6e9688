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

/// Throws std::bad_alloc.
Memory allocate(std::size_t size);

struct Bytes {
  Memory data;  ///< null when memory ran out
  std::size_t size = 0;
};

/// Makes the zlib stream of a picture's filtered rows. Throws std::bad_alloc and nothing else.
using Compress = std::function<Bytes(std::span<const std::uint8_t> rows)>;

/// The PNG file of 8-bit pixels, rows from the top without padding. A row is filtered without
/// regard to others, and becomes one byte longer. Any number of threads at once.
Bytes encode_png(const std::uint8_t* pixels, int width, int height, int channels,
                 const Compress& compress);

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

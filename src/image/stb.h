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
template <typename Value>
using Memory = std::unique_ptr<Value, Free>;

/// Filters rows of 8-bit pixels as PNG has them, each without regard to others and then one byte
/// longer, and gives them to `take`, which throws nothing. stb_image_write filters only what it
/// writes: the file that it makes of the rows is dropped. Any number of threads at once. Throws
/// std::bad_alloc.
void filter_rows(const std::uint8_t* pixels, int width, int rows, int channels,
                 const std::function<void(std::span<std::uint8_t>)>& take);

template <typename Sample>
struct Pixels {
  Memory<Sample> data;  ///< null when `failure` says why
  int width = 0;
  int height = 0;
  std::string failure;
};

/// The pixels of a PNG file as so many channels, 3 or 4, of 8 or 16 bits. Any number of threads at
/// once.
template <typename Sample>
Pixels<Sample> decode_png(std::span<const std::uint8_t> file, int channels);
template <>
Pixels<std::uint8_t> decode_png(std::span<const std::uint8_t> file, int channels);
template <>
Pixels<std::uint16_t> decode_png(std::span<const std::uint8_t> file, int channels);

}  // namespace twrench::stb

#include "image/stb.h"

#include <cstdlib>
#include <new>

namespace {

constexpr int png_filter = 1;  // the left neighbour's

/// What takes this thread's rows: stb_image_write's hook is a plain function.
thread_local const std::function<void(std::span<std::uint8_t>)>* taker = nullptr;

/// In place of a compressor: no bytes, in malloc'ed memory as stb_image_write expects them; null on
/// failure.
unsigned char* take_rows(unsigned char* data, int size, int* compressed_size, int level);

}  // namespace

// Static: the settings of stb_image_write, which are variables, are then this file's alone.
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#define STBIW_ZLIB_COMPRESS take_rows
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>

namespace {

unsigned char* take_rows(unsigned char* data, int size, int* compressed_size, int) {
  (*taker)({data, static_cast<std::size_t>(size)});
  *compressed_size = 0;
  return static_cast<unsigned char*>(std::malloc(1));
}

}  // namespace

namespace twrench::stb {
namespace {

template <typename Sample>
Pixels<Sample> decode(std::span<const std::uint8_t> file, int channels,
                      Sample* (*load)(const stbi_uc*, int, int*, int*, int*, int)) {
  Pixels<Sample> image;
  int stored = 0;
  image.data.reset(load(file.data(), static_cast<int>(file.size()), &image.width, &image.height,
                        &stored, channels));
  if (!image.data) image.failure = stbi_failure_reason();
  return image;
}

}  // namespace

void Free::operator()(void* memory) const noexcept { std::free(memory); }

void filter_rows(const std::uint8_t* pixels, int width, int rows, int channels,
                 const std::function<void(std::span<std::uint8_t>)>& take) {
  // The initialisation of a local static happens once, before any thread gets past it.
  static const int filter = stbi_write_force_png_filter = png_filter;
  static_cast<void>(filter);
  taker = &take;
  int size = 0;
  const Memory<std::uint8_t> dropped(
      stbi_write_png_to_mem(pixels, 0, width, rows, channels, &size));
  if (!dropped) throw std::bad_alloc();
}

template <>
Pixels<std::uint8_t> decode_png(std::span<const std::uint8_t> file, int channels) {
  return decode<std::uint8_t>(file, channels, &stbi_load_from_memory);
}

template <>
Pixels<std::uint16_t> decode_png(std::span<const std::uint8_t> file, int channels) {
  return decode<std::uint16_t>(file, channels, &stbi_load_16_from_memory);
}

}  // namespace twrench::stb

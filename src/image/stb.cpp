#include "image/stb.h"

#include <isa-l/crc.h>

#include <cstdlib>
#include <new>

namespace {

constexpr int png_filter = 1;  // the left neighbour's

/// With what this thread compresses: stb_image_write's hook is a plain function.
thread_local const twrench::stb::Compress* compress_of_thread = nullptr;

/// A zlib stream of the data in malloc'ed memory, as stb_image_write expects it; null on failure.
unsigned char* zlib_compress(unsigned char* data, int size, int* compressed_size, int level);

}  // namespace

// Static: the settings of stb_image_write, which are variables, are then this file's alone.
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#define STBIW_ZLIB_COMPRESS zlib_compress
#define STBIW_CRC32(bytes, size) crc32_gzip_refl(0, bytes, static_cast<std::uint64_t>(size))
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>

namespace {

unsigned char* zlib_compress(unsigned char* data, int size, int* compressed_size, int) {
  try {
    auto stream = (*compress_of_thread)({data, static_cast<std::size_t>(size)});
    *compressed_size = static_cast<int>(stream.size);
    return stream.data.release();
  } catch (const std::bad_alloc&) {  // through C code no exception goes
    return nullptr;
  }
}

}  // namespace

namespace twrench::stb {

void Free::operator()(void* memory) const noexcept { std::free(memory); }

Memory allocate(std::size_t size) {
  Memory memory(static_cast<std::uint8_t*>(std::malloc(size)));
  if (!memory) throw std::bad_alloc();
  return memory;
}

Bytes encode_png(const std::uint8_t* pixels, int width, int height, int channels,
                 const Compress& compress) {
  // The initialisation of a local static happens once, before any thread gets past it.
  static const int filter = stbi_write_force_png_filter = png_filter;
  static_cast<void>(filter);
  compress_of_thread = &compress;
  int size = 0;
  Memory data(stbi_write_png_to_mem(pixels, 0, width, height, channels, &size));
  return {std::move(data), static_cast<std::size_t>(size)};
}

Pixels decode_png(std::span<const std::uint8_t> file, int max_side) {
  const auto size = static_cast<int>(file.size());
  Pixels image;
  int stored = 0;
  if (stbi_info_from_memory(file.data(), size, &image.width, &image.height, &stored) == 0) {
    image.failure = stbi_failure_reason();
    return image;
  }
  if (image.width > max_side || image.height > max_side) {
    image.failure = "too large";
    return image;
  }
  image.channels = stored == 2 || stored == 4 ? 4 : 3;
  image.data.reset(stbi_load_from_memory(file.data(), size, &image.width, &image.height, &stored,
                                         image.channels));
  if (!image.data) {
    image.failure = stbi_failure_reason();
  }
  return image;
}

}  // namespace twrench::stb

#include "image/stb.h"

#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>

#include <cstdlib>
#include <new>

namespace {

constexpr int png_filter = 1;
constexpr int deflate_level = 1;
constexpr std::size_t deflate_memory = ISAL_DEF_LVL1_DEFAULT;

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
  const std::unique_ptr<std::uint8_t[]> memory(new (std::nothrow) std::uint8_t[deflate_memory]);
  // What does not compress is stored, in blocks of at most 65535 bytes with 5 before each (RFC
  // 1951, 3.2.4), between the 6 bytes of zlib (RFC 1950).
  const auto length = static_cast<std::uint32_t>(size);
  const std::uint32_t bound = length + 5 * (length / 65535 + 1) + 6 + ISAL_DEF_MAX_HDR_SIZE;
  auto* out = static_cast<unsigned char*>(std::malloc(bound));
  isal_zstream stream{};  // the next line leaves some unset of what is read
  isal_deflate_stateless_init(&stream);
  stream.level = deflate_level;
  stream.level_buf = memory.get();
  stream.level_buf_size = deflate_memory;
  stream.gzip_flag = IGZIP_ZLIB;
  stream.end_of_stream = 1;
  stream.next_in = data;
  stream.avail_in = length;
  stream.next_out = out;
  stream.avail_out = bound;
  if (!memory || out == nullptr || isal_deflate_stateless(&stream) != COMP_OK) {
    std::free(out);
    return nullptr;
  }
  *compressed_size = static_cast<int>(stream.total_out);
  return out;
}

}  // namespace

namespace twrench::stb {

void Free::operator()(void* memory) const noexcept { std::free(memory); }

Bytes encode_png(const std::uint8_t* pixels, int width, int height, int channels) {
  // The initialisation of a local static happens once, before any thread gets past it.
  static const int filter = stbi_write_force_png_filter = png_filter;
  static_cast<void>(filter);
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

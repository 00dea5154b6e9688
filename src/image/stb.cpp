#include "image/stb.h"

// Static, so that the settings of stb_image_write, which are variables, belong to this file alone.
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

namespace twrench::image::stb {

// The only step of stb_image_write that is needed, by its internal name: the public functions run
// it only together with their own compressor and checksums.
void filter_row(std::span<const std::uint8_t> row, int channels, std::span<std::uint8_t> filtered) {
  constexpr int sub = 1, rows = 1, first = 0;
  const int size = static_cast<int>(row.size());
  filtered[0] = sub;
  stbiw__encode_png_line(const_cast<std::uint8_t*>(row.data()), size, size / channels, rows, first,
                         channels, sub, reinterpret_cast<signed char*>(&filtered[1]));
}

std::vector<std::uint8_t> jpeg(const Image& image, int quality) {
  std::vector<std::uint8_t> bytes;
  const auto append = [](void* to, void* data, int size) {
    const auto* begin = static_cast<const std::uint8_t*>(data);
    auto& file = *static_cast<std::vector<std::uint8_t>*>(to);
    file.insert(file.end(), begin, begin + size);
  };
  stbi_write_jpg_to_func(append, &bytes, image.width, image.height, image.channels,
                         image.pixels.data(), quality);
  return bytes;
}

}  // namespace twrench::image::stb

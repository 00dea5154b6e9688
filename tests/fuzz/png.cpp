// PNG files: frames that encode and --resume read, images that compare reads.
#include "image/png.h"

#include <zlib.h>

#include <cstdint>
#include <vector>

#include "system/error.h"
#include "target.h"

namespace {

using namespace twrench;

std::uint32_t big_endian(const std::uint8_t* bytes) {
  return std::uint32_t{bytes[0]} << 24U | std::uint32_t{bytes[1]} << 16U |
         std::uint32_t{bytes[2]} << 8U | bytes[3];
}

/// Returns the file with correct chunk checksums. Otherwise the reader would reject a mutation by
/// its checksum, and later code would not be tested.
std::vector<std::uint8_t> with_checksums(const std::uint8_t* data, std::size_t size) {
  std::vector<std::uint8_t> file(data, data + size);
  constexpr std::size_t signature = 8, around_data = 12;  // length and type before, checksum after
  for (std::size_t at = signature; at + around_data <= size;) {
    const std::size_t length = big_endian(&file[at]);
    if (length > size - at - around_data) break;
    const auto sum =
        static_cast<std::uint32_t>(crc32(0, &file[at + 4], static_cast<unsigned>(length) + 4));
    at += 8 + length;
    for (unsigned i = 0; i < 4; ++i) file[at++] = static_cast<std::uint8_t>(sum >> (24U - 8U * i));
  }
  return file;
}

void decode(std::span<const std::uint8_t> file) {
  try {
    const image::Image image = image::decode_png(file, "input");
    require(image.pixels.size() == image.row_bytes() * static_cast<std::size_t>(image.height),
            "as many pixels as it says");
    require(image::decode_png(image::encode_png(image), "written").pixels == image.pixels,
            "read back");
  } catch (const system::FileError&) {
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  decode({data, size});
  decode(with_checksums(data, size));
  return 0;
}

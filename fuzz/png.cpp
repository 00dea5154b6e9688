// PNG files: frames that encode and --resume read, images that compare reads.
#include "image/png.h"

#include "base/error.h"
#include "target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace twrench;
  try {
    const Image image = decode_png({data, size}, "input");
    require(image.pixels.size() == image.row_bytes() * static_cast<std::size_t>(image.height),
            "as many pixels as it says");
    require(decode_png(encode_png(image), "written").pixels == image.pixels, "read back");
  } catch (const FileError&) {
  }
  return 0;
}

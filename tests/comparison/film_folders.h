#pragma once

#include <filesystem>
#include <string>

#include "comparison/comparison.h"
#include "image/png.h"
#include "scratch_folder.h"
#include "system/file.h"

namespace twrench::comparison {

/// Two folders, "expected" and "actual", for frames of 8x8 pixels.
class FilmFolders {
 public:
  FilmFolders() {
    for (const auto& folder : {expected(), actual()}) system::make_folder(folder);
  }

  std::filesystem::path expected() const { return scratch_ / "expected"; }
  std::filesystem::path actual() const { return scratch_ / "actual"; }
  Inputs inputs() const { return {expected(), actual(), true}; }

  /// Writes a gray frame whose first channel of the first pixel is `value`.
  static void write(const std::filesystem::path& file, int value, int width = 8) {
    image::Image image(width, 8, 3);
    std::ranges::fill(image.pixels, std::uint8_t{100});
    image.pixels[0] = static_cast<std::uint8_t>(value);
    system::write_file_atomically(file, image::encode_png(image));
  }

 private:
  const ScratchFolder scratch_;
};

}  // namespace twrench::comparison

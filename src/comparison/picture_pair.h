#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "image/area.h"
#include "image/compare.h"
#include "image/image.h"
#include "system/error.h"

namespace twrench::comparison {

/// The bytes of a PNG file, and its name in errors.
struct PngFile {
  std::span<const std::uint8_t> bytes;
  std::string name;
};

/// Throws InvalidArgument unless each area lies within an image of this size and is not all of it.
/// `name` is the file of the image.
void require_within(std::span<const image::Area> areas, int width, int height,
                    const std::string& name);

/// Two images to compare: with 16 bits per channel if either file has them, otherwise with 8. An
/// alpha channel that is opaque everywhere is dropped if only one file has alpha, and the colours
/// of pixels that are invisible in both become equal.
class PicturePair {
 public:
  /// Throws FileError as image::decode_png() does.
  PicturePair(const PngFile& expected, const PngFile& actual);

  /// Whether they have the same size and number of channels. All functions below except formats()
  /// require this.
  bool same_format() const;

  /// Returns a sentence for each way in which the files differ that does not make the images
  /// different: the number of channels or bits, invisible colours, and chunks that describe
  /// colours.
  const std::vector<std::string>& notes() const { return notes_; }

  /// "640x360 with 3 channels, and 640x360 with 4"
  std::string formats() const;

  /// Makes the actual image equal to the expected one within the areas. Throws InvalidArgument
  /// as require_within() does.
  void ignore(std::span<const image::Area> areas);

  /// As image::compare().
  image::Difference difference(int threshold, int edges) const;

  /// As image::structural_similarity().
  double similarity() const;

  /// As image::difference_image().
  image::Image difference_image(int edges) const;

 private:
  template <typename Kind>
  using Pair = std::pair<Kind, Kind>;

  void unify_alpha();

  std::variant<Pair<image::Image>, Pair<image::DeepImage>> images_;
  std::vector<std::string> notes_;
  std::string name_;  ///< The name of the actual file.
};

}  // namespace twrench::comparison

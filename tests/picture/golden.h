#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "image/compare.h"
#include "image/png.h"
#include "system/file.h"

namespace twrench::picture {

inline std::filesystem::path golden_path(const std::string& name) {
  return std::filesystem::path(TWRENCH_TESTS_DIR) / "golden" / (name + ".png");
}

/// Mesa 22.3, 25.0 and 26.1 differ by one level of 255, and by 0.0001 in the mean; on labels, whose
/// font differs too, by 9 and 0.004 (docs/platforms.md). Other drivers round one edge pixel in a
/// thousand by a sample. Half a degree of pose changes the mean by more than this.
inline bool alike(const image::Image& a, const image::Image& b) {
  constexpr int threshold = 4;
  constexpr double allowed_share = 0.001;
  constexpr double allowed_mean = 0.02;
  const auto difference = image::compare(a, b, threshold);
  return difference && difference->share <= allowed_share && difference->mean <= allowed_mean;
}

/// Whether two images are close enough to count as the same.
using Alike = bool (*)(const image::Image&, const image::Image&);

/// Compares an image with the golden one of that name or, if TWRENCH_UPDATE_GOLDENS is set,
/// replaces the golden image.
inline void expect_golden(const std::string& name, const image::Image& actual,
                          Alike close = alike) {
  namespace fs = std::filesystem;
  const fs::path path = golden_path(name);
  if (std::getenv("TWRENCH_UPDATE_GOLDENS") != nullptr) {
    system::write_file_atomically(path, image::encode_png(actual));
    return;
  }
  const image::Image golden = image::read_png(path);
  const auto difference = image::compare(actual, golden, 0);
  if (difference) {  // reported by --gtest_output=xml, for docs/platforms.md
    testing::Test::RecordProperty("largest", fmt::format("{:g}", difference->max));
    testing::Test::RecordProperty("mean", fmt::format("{:.4f}", difference->mean));
  }
  if (close(actual, golden)) return;
  const fs::path folder(TWRENCH_SCRATCH);
  const fs::path actual_path = folder / (name + "-actual.png");
  const fs::path difference_path = folder / (name + "-difference.png");
  system::make_folder(folder);
  system::write_file_atomically(actual_path, image::encode_png(actual));
  ASSERT_TRUE(difference.has_value()) << "another size than " << path << "; see " << actual_path;
  system::write_file_atomically(difference_path,
                                image::encode_png(image::difference_image(actual, golden)));
  ADD_FAILURE() << path << ": max " << difference->max << ", mean " << difference->mean << "; see "
                << actual_path << " and " << difference_path;
}

}  // namespace twrench::picture

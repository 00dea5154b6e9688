#include <gtest/gtest.h>
#include <twrench/base/error.h>

#include <cmath>

#include "image/compare.h"
#include "image/sample_image.h"

namespace twrench::image {
namespace {

/// The definition, window by window.
template <typename Sample>
double by_definition(const BasicImage<Sample>& a, const BasicImage<Sample>& b, double range) {
  constexpr int window = similarity_window, n = window * window;
  const double c1 = std::pow(0.01 * range, 2), c2 = std::pow(0.03 * range, 2);
  double sum = 0;
  int count = 0;
  for (int c = 0; c < a.channels; ++c) {
    for (int y = 0; y + window <= a.height; ++y) {
      for (int x = 0; x + window <= a.width; ++x, ++count) {
        double mean_a = 0, mean_b = 0, var_a = 0, var_b = 0, covariance = 0;
        const auto each = [&](const auto& use) {
          for (int i = 0; i < n; ++i) {
            const auto at = static_cast<std::size_t>(
                ((y + i / window) * a.width + x + i % window) * a.channels + c);
            use(double(a.pixels[at]), double(b.pixels[at]));
          }
        };
        each([&](double p, double q) { mean_a += p / n, mean_b += q / n; });
        each([&](double p, double q) {
          var_a += (p - mean_a) * (p - mean_a) / (n - 1);
          var_b += (q - mean_b) * (q - mean_b) / (n - 1);
          covariance += (p - mean_a) * (q - mean_b) / (n - 1);
        });
        sum += (2 * mean_a * mean_b + c1) * (2 * covariance + c2) /
               ((mean_a * mean_a + mean_b * mean_b + c1) * (var_a + var_b + c2));
      }
    }
  }
  return sum / count;
}

template <typename Sample>
BasicImage<Sample> random_image(int width, int height, int channels, unsigned seed) {
  BasicImage<Sample> image(width, height, channels);
  std::mt19937 random(seed);
  for (Sample& sample : image.pixels) sample = static_cast<Sample>(random());
  return image;
}

TEST(Similarity, OfEqualImagesIsOne) {
  const Image image = sample_image(20, 10, 3, 1);
  EXPECT_EQ(structural_similarity(image, image), 1.0);
}

TEST(Similarity, IsWhatTheDefinitionSays) {
  for (const auto& [width, height] : {std::pair{7, 7}, {8, 7}, {7, 9}, {31, 20}}) {
    for (const int channels : {3, 4}) {
      const auto a = random_image<std::uint8_t>(width, height, channels, 1);
      const auto b = random_image<std::uint8_t>(width, height, channels, 2);
      EXPECT_NEAR(structural_similarity(a, b), by_definition(a, b, 255), 1e-12);
      const auto deep_a = random_image<std::uint16_t>(width, height, channels, 3);
      const auto deep_b = random_image<std::uint16_t>(width, height, channels, 4);
      EXPECT_NEAR(structural_similarity(deep_a, deep_b), by_definition(deep_a, deep_b, 65535),
                  1e-12);
    }
  }
}

// Only windows with a change are computed, and the change may be anywhere.
TEST(Similarity, SeesASingleSampleWhereverItIs) {
  const Image a = sample_image(15, 13, 3, 1);
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    Image b = a;
    b.pixels[i] ^= 0x80;
    ASSERT_NEAR(structural_similarity(a, b), by_definition(a, b, 255), 1e-12) << i;
    ASSERT_EQ(structural_similarity(a, b), structural_similarity(b, a)) << i;
  }
}

TEST(Similarity, DoesNotOverflow) {
  Image black(9, 9, 3), white(9, 9, 3), checkered(9, 9, 3);
  std::ranges::fill(white.pixels, std::uint8_t{255});
  for (std::size_t i = 0; i < checkered.pixels.size(); ++i) {
    checkered.pixels[i] = i / 3 % 2 == 0 ? 255 : 0;
  }
  for (const auto& [a, b] : {std::pair{black, white}, {white, checkered}, {black, checkered}}) {
    EXPECT_NEAR(structural_similarity(a, b), by_definition(a, b, 255), 1e-12);
  }
}

TEST(Similarity, NeedsAWindow) {
  for (const auto& [width, height] : {std::pair{6, 20}, {20, 6}}) {
    const Image image(width, height, 3);
    EXPECT_THROW(structural_similarity(image, image), InvalidArgument);
  }
}

/// The same pixels as those of tests/python/test_compare.py.
Image pattern(int width, int height, int seed) {
  Image image(width, height, 3);
  std::size_t i = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const int value = 3 * x + 5 * y + 40 * c + (x * y + seed * (x + 2 * y + c)) % (17 + seed);
        image.pixels[i++] = static_cast<std::uint8_t>(value % 256);
      }
    }
  }
  return image;
}

// The last column is scikit-image's structural_similarity(a, b, channel_axis=-1). That test
// compares the program with scikit-image itself if it is installed.
TEST(Similarity, IsThatOfScikitImage) {
  struct Case {
    int a, b;
    double similarity;
  };
  for (const Case& c :
       {Case{1, 2, 0.744929595767}, {3, 30, 0.411946733652}, {9, 10, 0.668184732218}}) {
    EXPECT_NEAR(structural_similarity(pattern(60, 40, c.a), pattern(60, 40, c.b)), c.similarity,
                1e-11)
        << c.a;
  }
}

}  // namespace
}  // namespace twrench::image

#include <gmock/gmock.h>

#include <random>
#include <vector>

#include "image/yuv.h"

namespace twrench::image {
namespace {

using testing::ElementsAreArray;

// Widths that are not multiples of the vector size, or smaller than it.
class YuvRowsOf : public testing::TestWithParam<int> {};

TEST_P(YuvRowsOf, AreTheSameWithTheWidestInstructions) {
  const auto count = static_cast<std::size_t>(GetParam());
  std::mt19937 random(1);
  std::vector<std::uint8_t> upper(3 * count);
  std::vector<std::uint8_t> lower(3 * count);
  for (auto* row : {&upper, &lower}) {
    for (std::uint8_t& value : *row) value = static_cast<std::uint8_t>(random() & 255U);
  }
  struct Converted {
    std::vector<std::uint8_t> luma, chroma;
    std::vector<int> blue, red;
  };
  const auto converted = [&](const YuvRows& rows) {
    const std::size_t samples = (count - 1) / 2;
    Converted result{std::vector<std::uint8_t>(count), std::vector<std::uint8_t>(samples),
                     std::vector<int>(count), std::vector<int>(count)};
    rows.luma(upper.data(), result.luma.data(), static_cast<int>(count));
    rows.columns(upper.data(), lower.data(), result.blue.data(), result.red.data(),
                 static_cast<int>(count));
    rows.chroma(result.blue.data(), result.chroma.data(), static_cast<int>(samples));
    return result;
  };
  const Converted common = converted(common_yuv_rows());
  const Converted fastest = converted(fastest_yuv_rows());
  EXPECT_THAT(fastest.luma, ElementsAreArray(common.luma));
  EXPECT_THAT(fastest.blue, ElementsAreArray(common.blue));
  EXPECT_THAT(fastest.red, ElementsAreArray(common.red));
  EXPECT_THAT(fastest.chroma, ElementsAreArray(common.chroma));
}

INSTANTIATE_TEST_SUITE_P(Counts, YuvRowsOf, testing::Values(3, 37, 1920));

}  // namespace
}  // namespace twrench::image

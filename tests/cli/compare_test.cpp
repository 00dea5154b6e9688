#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/file.h"
#include "cli/twrench.h"
#include "image/png.h"

namespace twrench {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

Image gray(int width, int height) {
  Image image(width, height, 3);
  std::ranges::fill(image.pixels, std::uint8_t{100});
  return image;
}

class Compare : public testing::Test {
 protected:
  Compare() {
    write_file_atomically(folder_ / "a.png", encode_png(gray(10, 10)));
    Image other = gray(10, 10);
    other.pixels[0] = 130;
    write_file_atomically(folder_ / "b.png", encode_png(other));
    write_file_atomically(folder_ / "wide.png", encode_png(gray(20, 10)));
  }
  const ScratchFolder folder_;
};

TEST_F(Compare, Alike) {
  const Outcome run = run_twrench(folder_, "compare a.png a.png");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out, StartsWith("alike: max 0"));
}

TEST_F(Compare, DifferentWithTheDifferenceDrawn) {
  const Outcome run = run_twrench(folder_, "compare a.png b.png --diff d.png");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, StartsWith("different: max 30"));
  const Image difference = read_png(folder_ / "d.png");
  EXPECT_EQ(difference.pixels[0], 255);
  EXPECT_EQ(difference.pixels[3], 0);
}

TEST_F(Compare, ThresholdAndShare) {
  EXPECT_EQ(run_twrench(folder_, "compare a.png b.png --threshold 30").code, 0);
  EXPECT_EQ(run_twrench(folder_, "compare a.png b.png --threshold 29").code, 1);
  EXPECT_EQ(run_twrench(folder_, "compare a.png b.png --share 0.01").code, 0);
  EXPECT_EQ(run_twrench(folder_, "compare a.png b.png --share 0.0099").code, 1);
}

TEST_F(Compare, SizesThatDiffer) {
  const Outcome run = run_twrench(folder_, "compare a.png wide.png");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, HasSubstr("10x10"));
}

TEST_F(Compare, FilesThatCannotBeRead) {
  EXPECT_EQ(run_twrench(folder_, "compare a.png missing.png").code, 5);
  write_file_atomically(folder_ / "text.png", "no picture");
  EXPECT_EQ(run_twrench(folder_, "compare a.png text.png").code, 5);
}

}  // namespace
}  // namespace twrench

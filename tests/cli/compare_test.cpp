#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/twrench.h"
#include "image/png.h"
#include "system/file.h"

namespace twrench {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

image::Image gray(int width, int height) {
  image::Image image(width, height, 3);
  std::ranges::fill(image.pixels, std::uint8_t{100});
  return image;
}

class Compare : public testing::Test {
 protected:
  Compare() {
    system::write_file_atomically(folder_ / "a.png", image::encode_png(gray(10, 10)));
    image::Image other = gray(10, 10);
    other.pixels[0] = 130;
    system::write_file_atomically(folder_ / "b.png", image::encode_png(other));
    system::write_file_atomically(folder_ / "wide.png", image::encode_png(gray(20, 10)));
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
  const image::Image difference = image::read_png(folder_ / "d.png");
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

TEST_F(Compare, AnEndingAloneIsNoName) {
  for (const char* option : {"--report .html", "--diff .png"}) {
    const Outcome run = run_twrench(folder_, std::string("compare a.png b.png ") + option);
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.err, HasSubstr("there is no name before the ending"));
  }
}

TEST_F(Compare, TheLowByteIsADifference) {
  const std::string pam =
      "printf 'P7\\nWIDTH 1\\nHEIGHT 1\\nDEPTH 3\\nMAXVAL 65535\\nTUPLTYPE "
      "RGB\\nENDHDR\\n\\001\\002\\003\\004\\005\\";
  const std::string to_png = "' | ffmpeg -v error -f image2pipe -c:v pam -i - -pix_fmt rgb48be ";
  ASSERT_EQ(
      run_shell(folder_, pam + "006" + to_png + "c.png && " + pam + "007" + to_png + "d.png").code,
      0);
  const Outcome run = run_twrench(folder_, "compare c.png d.png");
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_THAT(run.out, StartsWith("different: max 0.00389105 "));
  EXPECT_EQ(run_twrench(folder_, "compare c.png c.png").code, 0);
}

TEST_F(Compare, DamagedFilesAreRefused) {
  const std::string png = text_of(folder_ / "a.png");
  std::string checksum = png, cut = png.substr(0, png.size() - 30);
  checksum[png.size() - 13] ^= 1;
  for (const std::string& damaged : {checksum, cut}) {
    system::write_file_atomically(folder_ / "damaged.png", damaged);
    const Outcome run = run_twrench(folder_, "compare damaged.png damaged.png");
    EXPECT_EQ(run.code, 5) << run.out;
    EXPECT_THAT(run.err, StartsWith("twrench: error: cannot read damaged.png: "));
    EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;
  }
}

TEST_F(Compare, FilesThatCannotBeRead) {
  EXPECT_EQ(run_twrench(folder_, "compare a.png missing.png").code, 5);
  system::write_file_atomically(folder_ / "text.png", "no picture");
  EXPECT_EQ(run_twrench(folder_, "compare a.png text.png").code, 5);
}

}  // namespace
}  // namespace twrench

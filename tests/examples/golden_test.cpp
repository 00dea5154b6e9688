// examples/golden, copied to a separate folder.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/twrench.h"
#include "image/png.h"
#include "system/file.h"

namespace twrench {
namespace {

using testing::HasSubstr;

class GoldenExample : public testing::Test {
 protected:
  GoldenExample() {
    std::filesystem::copy(TWRENCH_TESTS_DIR "/../examples/golden", folder_ / "project",
                          std::filesystem::copy_options::recursive);
  }

  Outcome check(const std::string& options = "") const {
    return run_shell(folder_, "project/check.sh " + options);
  }

  std::filesystem::path golden(const std::string& name) const {
    return folder_ / "project/golden" / name;
  }

  const ScratchFolder folder_;
};

TEST_F(GoldenExample, PassesWithThisMachinesOpenGL) {
  const Outcome run = check();
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_THAT(run.out, HasSubstr("alike: 0 of 3 frames differ"));
}

TEST_F(GoldenExample, FailsWhenAGoldenFrameIsTouched) {
  image::Image image = image::read_png(golden("frame_000052.png"));
  for (std::size_t i = 0; i < 3; ++i) image.pixels[i] ^= 0x20;  // a pixel of the background
  system::write_file_atomically(golden("frame_000052.png"), image::encode_png(image));
  const Outcome run = check();
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_THAT(run.out, HasSubstr("frame_000052.png: different: max "));
  EXPECT_THAT(text_of(folder_ / "project/out/report.html"),
              HasSubstr("1 of 3 frames is not as expected"));
}

TEST_F(GoldenExample, FailsWhenTheBodyOrItsMotionIsAnother) {
  const auto scene = folder_ / "project/racket.toml";
  std::string text = text_of(scene);
  text.replace(text.find("radius = 1.5"), 12, "radius = 1.6");
  system::write_file_atomically(scene, text);
  EXPECT_EQ(check().code, 1);
}

TEST_F(GoldenExample, UpdateAcceptsTheNewFrames) {
  std::filesystem::copy_file(golden("frame_000013.png"), golden("frame_000104.png"),
                             std::filesystem::copy_options::overwrite_existing);
  EXPECT_EQ(check("--update").code, 0);
  EXPECT_EQ(check().code, 0);
}

}  // namespace
}  // namespace twrench

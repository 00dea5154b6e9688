#include "gl/framebuffer.h"

#include <gmock/gmock.h>
#include <twrench/base/error.h>

#include "gl_fixture.h"

namespace twrench::gl {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class FramebufferTest : public GlTest, public testing::WithParamInterface<int> {
 protected:
  void fill(const Framebuffer& framebuffer, const Rectangle& area, float red, float green) const {
    framebuffer.draw_within(area, {0, 0, framebuffer.width(), framebuffer.height()});
    gl.ClearColor(red, green, 0, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }
};

std::vector<int> pixel(const image::Image& image, int x, int y) {
  const auto* p = &image.pixels[static_cast<std::size_t>(y) * image.row_bytes() +
                                static_cast<std::size_t>(4 * x)];
  return {p[0], p[1], p[2], p[3]};
}

TEST_P(FramebufferTest, ReadsFromTheTopLeft) {
  const Framebuffer framebuffer(gl, 5, 3, GetParam(), ReadMode::at_once);
  fill(framebuffer, {0, 0, 5, 3}, 0, 1);
  fill(framebuffer, {1, 2, 1, 1}, 1, 0);  // the second pixel of the top row
  const image::Image image = framebuffer.begin_read({0, 0, 5, 3}).finish();
  EXPECT_EQ(image.width, 5);
  EXPECT_EQ(image.height, 3);
  EXPECT_EQ(image.channels, 4);
  EXPECT_THAT(pixel(image, 1, 0), ElementsAre(255, 0, 0, 255));
  EXPECT_THAT(pixel(image, 1, 2), ElementsAre(0, 255, 0, 255));
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

TEST_P(FramebufferTest, ReadsAnAreaAlone) {
  const Framebuffer framebuffer(gl, 8, 8, GetParam(), ReadMode::at_once);
  fill(framebuffer, {0, 0, 8, 8}, 0, 1);
  fill(framebuffer, {3, 5, 1, 1}, 1, 0);
  const image::Image image = framebuffer.begin_read({3, 4, 2, 2}).finish();
  EXPECT_EQ(image.width, 2);
  EXPECT_EQ(image.height, 2);
  EXPECT_THAT(pixel(image, 0, 0), ElementsAre(255, 0, 0, 255));
  EXPECT_THAT(pixel(image, 1, 1), ElementsAre(0, 255, 0, 255));
}

INSTANTIATE_TEST_SUITE_P(Samples, FramebufferTest, testing::Values(1, 4));

TEST_F(FramebufferTest, RefusesASizePastTheLimit) {
  try {
    const Framebuffer framebuffer(gl, 1'000'000, 10, 1, ReadMode::at_once);
    FAIL() << "no exception";
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("size 1000000x10: this OpenGL implementation draws at most"));
    EXPECT_THAT(error.remedy(), HasSubstr("choose a size of at most"));
  }
}

TEST_F(FramebufferTest, RefusesMoreSamplesThanThereAre) {
  try {
    const Framebuffer framebuffer(gl, 16, 16, 1024, ReadMode::at_once);
    FAIL() << "no exception";
  } catch (const OutOfRange& error) {
    EXPECT_EQ(error.value(), 1024);
    EXPECT_GE(error.greatest(), 1);
    EXPECT_THAT(error.what(),
                HasSubstr("samples 1024: this OpenGL implementation supports at most"));
    EXPECT_THAT(error.remedy(), HasSubstr("samples or fewer"));
  }
}

}  // namespace
}  // namespace twrench::gl

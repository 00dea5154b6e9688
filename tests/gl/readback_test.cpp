#include <array>
#include <initializer_list>
#include <vector>

#include "gl/context.h"
#include "gl/framebuffer.h"
#include "gl_fixture.h"

namespace twrench::gl {
namespace {

constexpr int width = 37, height = 23;

/// Draws a slanted triangle over the middle, whose colour varies from pixel to pixel and with
/// `shade`.
class Drawn {
 public:
  Drawn(const Functions& gl, int samples, ReadMode mode)
      : gl_(gl), framebuffer_(gl, width, height, samples, mode), program_(program(gl)), none_(gl) {}

  void draw(float shade) const {
    constexpr Rectangle all{0, 0, width, height};
    framebuffer_.clear({&all, 1});
    framebuffer_.draw_within(all, all);
    program_.use();
    program_.set("shade", shade);
    gl_.BindVertexArray(none_.id());
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  }

  Readback begin_read(const Rectangle& area) const { return framebuffer_.begin_read(area); }

 private:
  static Program program(const Functions& gl) {
    const std::array vertex{
        ShaderFile{"drawn.vert",
                   "void main() { gl_Position = vec4(1.8 * (gl_VertexID % 2) - 0.9, "
                   "1.7 * (gl_VertexID / 2) - 0.8, 0, 1); }"}};
    const std::array fragment{
        ShaderFile{"drawn.frag",
                   "uniform float shade; out vec4 color;"
                   "void main() { color = vec4(gl_FragCoord.xy / 40, shade, 1); }"}};
    return {gl, vertex, fragment};
  }

  const Functions& gl_;
  Framebuffer framebuffer_;
  Program program_;
  VertexArray none_;
};

class ReadbackTest : public GlTest, public testing::WithParamInterface<int> {
 protected:
  /// Returns the pixels of that picture, read at once.
  std::vector<std::uint8_t> expected(float shade, const Rectangle& area) const {
    const Drawn at_once(gl, GetParam(), ReadMode::at_once);
    at_once.draw(shade);
    return at_once.begin_read(area).finish().pixels;
  }
};

const std::initializer_list<Rectangle> areas{
    {0, 0, width, height}, {3, 5, 1, 1}, {7, 2, 21, 13}, {0, 22, 37, 1}, {36, 0, 1, 23}};

TEST_P(ReadbackTest, GivesTheSameBytesThroughABuffer) {
  const Drawn buffered(gl, GetParam(), ReadMode::buffered);
  for (const Rectangle& area : areas) {
    buffered.draw(0.5F);
    Readback readback = buffered.begin_read(area);
    EXPECT_FALSE(readback.is_ready());
    const auto pixels = expected(0.5F, area);  // read while the other is in transfer
    const image::Image image = readback.finish();
    EXPECT_EQ(image.width, area.width);
    EXPECT_EQ(image.height, area.height);
    EXPECT_EQ(image.pixels, pixels) << area.width << "x" << area.height;
  }
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

TEST_P(ReadbackTest, KeepsSeveralOnTheirWayApart) {
  const Drawn buffered(gl, GetParam(), ReadMode::buffered);
  constexpr Rectangle small{5, 4, 9, 11}, large{1, 2, 35, 20};
  for (const auto& [first, second, third] :
       {std::array{small, small, large}, {large, small, small}, {small, large, large}}) {
    buffered.draw(0.2F);
    Readback one = buffered.begin_read(first);
    buffered.draw(0.5F);
    Readback two = buffered.begin_read(second);
    buffered.draw(0.8F);
    Readback three = buffered.begin_read(third);
    EXPECT_EQ(three.finish().pixels, expected(0.8F, third));
    EXPECT_EQ(one.finish().pixels, expected(0.2F, first));
    EXPECT_EQ(two.finish().pixels, expected(0.5F, second));
  }
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

TEST_P(ReadbackTest, MayBeLeftUntaken) {
  const Drawn buffered(gl, GetParam(), ReadMode::buffered);
  constexpr Rectangle area{2, 3, 20, 10};
  buffered.draw(0.2F);
  { const Readback left = buffered.begin_read(area); }
  buffered.draw(0.6F);
  EXPECT_EQ(buffered.begin_read(area).finish().pixels, expected(0.6F, area));
}

INSTANTIATE_TEST_SUITE_P(Samples, ReadbackTest, testing::Values(1, 4));

using PixelBuffersTest = GlTest;

TEST_F(PixelBuffersTest, AreUsedAgain) {
  PixelBuffers buffers(gl);
  PixelBuffers::Sized one = buffers.get(100);
  PixelBuffers::Sized other = buffers.get(200);
  EXPECT_NE(one.buffer.id(), other.buffer.id()) << "both are in use";
  const GLuint id = other.buffer.id();
  buffers.give_back(std::move(other));
  PixelBuffers::Sized again = buffers.get(150);
  EXPECT_EQ(again.buffer.id(), id);
  EXPECT_EQ(again.size, 200) << "large enough, so left as it was";
  buffers.give_back(std::move(again));
  EXPECT_EQ(buffers.get(300).size, 300) << "or made larger";
}

TEST_F(PixelBuffersTest, ComeBackFromAReadbackThatIsTaken) {
  const Framebuffer framebuffer(gl, 4, 4, 1, ReadMode::at_once);
  framebuffer.begin_read({0, 0, 4, 4}).finish();  // from now on it is bound for reading
  PixelBuffers buffers(gl);
  PixelBuffers::Sized one = buffers.get(64);
  const GLuint id = one.buffer.id();
  buffers.give_back(std::move(one));
  Readback readback(gl, {0, 0, 4, 4}, &buffers);
  const PixelBuffers::Sized other = buffers.get(64);
  EXPECT_NE(other.buffer.id(), id) << "which is in use";
  readback.finish();
  EXPECT_EQ(buffers.get(64).buffer.id(), id);
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

class ReadModeTest : public GlTest {
 protected:
  ReadMode best_for(PFNGLGETSTRINGPROC name) {
    gl.GetString = name;
    return best_read_mode(gl);
  }
};

TEST_F(ReadModeTest, IsAtOnceInSoftwareAlone) {
  EXPECT_EQ(best_read_mode(gl), ReadMode::at_once);
  const auto softpipe = [](GLenum) { return reinterpret_cast<const GLubyte*>("softpipe"); };
  const auto card = [](GLenum) { return reinterpret_cast<const GLubyte*>("AMD Radeon RX 580"); };
  EXPECT_EQ(best_for(softpipe), ReadMode::at_once);
  EXPECT_EQ(best_for(card), ReadMode::buffered);
}

TEST_F(ReadModeTest, DecidesWhetherPixelsAreThere) {
  const Drawn at_once(gl, 1, ReadMode::at_once);
  EXPECT_TRUE(at_once.begin_read({0, 0, 4, 4}).is_ready());
}

TEST_F(ReadModeTest, ReportsLostPixels) {
  const Drawn buffered(gl, 1, ReadMode::buffered);
  Readback readback = buffered.begin_read({0, 0, 4, 4});
  gl.UnmapBuffer = [](GLenum) -> GLboolean { return GL_FALSE; };
  EXPECT_THROW(readback.finish(), GlError);
}

}  // namespace
}  // namespace twrench::gl

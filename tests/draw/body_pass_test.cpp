#include "draw/body_pass.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "gl/framebuffer.h"
#include "gl/test_context.h"
#include "picture/body/gap_closing.h"
#include "picture/t_wrench.h"

namespace twrench::draw {
namespace {

using picture::body_mesh;
using picture::body_model;
using picture::BodyModel;
using picture::Camera;
using picture::close_gaps;
using picture::dark_studio;
using picture::frame_sphere;
using picture::Material;
using picture::Studio;
using picture::t_wrench;
using picture::white_studio;

/// OpenGL's own description of a program, from functions that only this test uses.
class Reflection {
 public:
  Reflection(const gl::Context& context, GLuint program)
      : get_uniform_(
            reinterpret_cast<PFNGLGETACTIVEUNIFORMPROC>(context.function("glGetActiveUniform"))),
        get_values_(reinterpret_cast<PFNGLGETUNIFORMFVPROC>(context.function("glGetUniformfv"))),
        program_(program) {}

  std::string uniform_name(GLuint index) const {
    std::array<char, 128> name{};
    GLsizei length = 0;
    GLint size = 0;
    GLenum type = 0;
    get_uniform_(program_, index, static_cast<GLsizei>(name.size()), &length, &size, &type,
                 name.data());
    return {name.data(), static_cast<std::size_t>(length)};
  }

  bool is_set(GLint location) const {
    std::array<float, 16> values{};
    get_values_(program_, location, values.data());
    return std::any_of(values.begin(), values.end(), [](float v) { return v != 0; });
  }

 private:
  PFNGLGETACTIVEUNIFORMPROC get_uniform_;
  PFNGLGETUNIFORMFVPROC get_values_;
  GLuint program_;
};

BodyModel wrench(double tolerance, const Material& material, const Studio& studio) {
  const std::vector<body::Part> parts = close_gaps(t_wrench().body.parts);
  return body_model(parts, body_mesh(parts, tolerance), 4.5, std::vector(parts.size(), material),
                    studio);
}

/// Runs with a metal and with a body that has a diffuse term, because these have two shaders.
class BodyPassTest : public testing::TestWithParam<float> {
 protected:
  std::unique_ptr<gl::Context> context = gl::make_test_context();
  gl::Functions gl{*context};
  BodyModel body =
      wrench(0.01, {glm::vec3(1), glm::vec3(GetParam()), glm::vec3(0.5F), 0.2F, 0.3F, 1.0F, false},
             dark_studio());
  BodyPass pass{gl, body};
};

INSTANTIATE_TEST_SUITE_P(Of, BodyPassTest, testing::Values(0.0F, 0.5F), [](const auto& param) {
  return std::string(param.param == 0 ? "Metal" : "Matte");
});

TEST_P(BodyPassTest, AgreesWithTheShaderOnTheAttributes) {
  EXPECT_EQ(gl.GetAttribLocation(pass.programs().front().id(), "position"), position_attribute);
  EXPECT_EQ(gl.GetAttribLocation(pass.programs().front().id(), "normal"), normal_attribute);
  EXPECT_EQ(gl.GetAttribLocation(pass.programs().front().id(), "shift"), shift_attribute);
  EXPECT_EQ(gl.GetAttribLocation(pass.programs().front().id(), "fade"), fade_attribute);
  GLint count = 0;
  gl.GetProgramiv(pass.programs().front().id(), GL_ACTIVE_ATTRIBUTES, &count);
  EXPECT_EQ(count, 4);
}

// Program::set itself checks that each uniform set by C++ exists in the shader.
TEST_P(BodyPassTest, SetsEveryUniformOfTheShader) {
  const gl::Framebuffer framebuffer(gl, 16, 16, 1, gl::ReadMode::at_once);
  framebuffer.draw_within({0, 0, 16, 16}, {0, 0, 16, 16});
  pass.draw_shrunk(frame_sphere({{0, 5, 20}, 0.55, 1.5, 4.5}), Eigen::Matrix3d::Identity(),
                   {0, 0, 16, 16});
  const GLuint program = pass.programs().front().id();
  const Reflection reflection(*context, program);
  GLint count = 0;
  gl.GetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
  EXPECT_GT(count, 0);
  for (GLint i = 0; i < count; ++i) {
    const std::string name = reflection.uniform_name(static_cast<GLuint>(i));
    EXPECT_TRUE(reflection.is_set(gl.GetUniformLocation(program, name.c_str()))) << name;
  }
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

/// Returns the largest difference of a channel between two pictures at a pixel.
int difference(const image::Image& a, const image::Image& b, std::size_t pixel) {
  int most = 0;
  for (std::size_t i = 4 * pixel; i < 4 * pixel + 4; ++i) {
    most = std::max(most, std::abs(a.pixels[i] - b.pixels[i]));
  }
  return most;
}

/// Returns the pixels of a picture that are at least four pixels inside the outline.
std::vector<std::size_t> within_outline(const image::Image& image) {
  const auto width = static_cast<std::size_t>(image.width);
  const std::size_t rows = static_cast<std::size_t>(image.height) - 4;
  std::vector<std::size_t> pixels;
  for (std::size_t i = 4 * width; i < rows * width; ++i) {
    const auto is_drawn = [&](std::size_t pixel) { return image.pixels[4 * pixel + 3] == 255; };
    if (is_drawn(i - 4) && is_drawn(i + 4) && is_drawn(i - 4 * width) && is_drawn(i + 4 * width)) {
      pixels.push_back(i);
    }
  }
  return pixels;
}

TEST_P(BodyPassTest, DrawsWideFacetsAsItDrawsNarrowOnes) {
  constexpr int side = 400;
  constexpr gl::Rectangle all{0, 0, side, side};
  const gl::Framebuffer framebuffer(gl, side, side, 1, gl::ReadMode::at_once);
  const Camera camera = frame_sphere({{0, 5, 20}, 0.55, 1, 4.5});
  const auto picture = [&](double tolerance, const Eigen::Matrix3d& X) {
    const BodyModel model =
        wrench(tolerance, {glm::vec3(1), glm::vec3(GetParam()), glm::vec3(0.5F), 0, 0.3F, 1, false},
               white_studio());
    BodyPass drawn(gl, model);
    framebuffer.clear({&all, 1});
    framebuffer.draw_within(all, all);
    drawn.draw_shrunk(camera, X, {0, 0, side, side});
    drawn.draw_edge_quads(camera, X);
    return framebuffer.begin_read(all).finish();
  };
  for (const double angle : {0.3, 1.2, 2.6}) {
    const Eigen::Matrix3d X =
        Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    const image::Image wide = picture(0.003, X), narrow = picture(0.003 / 16, X);
    const std::vector<std::size_t> pixels = within_outline(narrow);
    ASSERT_GT(pixels.size(), 10'000);
    const auto differ = std::ranges::count_if(
        pixels, [&](std::size_t i) { return difference(wide, narrow, i) > 3; });
    EXPECT_LT(static_cast<double>(differ), 0.01 * static_cast<double>(pixels.size()))
        << "more than edges and seams, at " << angle;
  }
}

}  // namespace
}  // namespace twrench::draw

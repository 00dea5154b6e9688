#include "render/body_pass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>

#include "gl/framebuffer.h"
#include "gl/test_context.h"
#include "t_wrench.h"

namespace twrench {
namespace {

/// What GL itself says of a program, with functions that only a test has use for.
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

/// A metal, and a body that scatters: two shaders.
class BodyPassTest : public testing::TestWithParam<float> {
 protected:
  std::unique_ptr<gl::Context> context = gl::make_test_context();
  gl::Functions gl{*context};
  BodyPass pass{gl,
                t_wrench().body.parts,
                0.01,
                4.5,
                Material{glm::vec3(GetParam()), glm::vec3(0.5F), 0.3F},
                dark_studio()};
};

INSTANTIATE_TEST_SUITE_P(Of, BodyPassTest, testing::Values(0.0F, 0.5F), [](const auto& param) {
  return std::string(param.param == 0 ? "Metal" : "Matte");
});

TEST_P(BodyPassTest, AgreesWithTheShaderOnTheAttributes) {
  EXPECT_EQ(gl.GetAttribLocation(pass.program().id(), "position"), position_attribute);
  EXPECT_EQ(gl.GetAttribLocation(pass.program().id(), "normal"), normal_attribute);
  EXPECT_EQ(gl.GetAttribLocation(pass.program().id(), "offset"), offset_attribute);
  GLint count = 0;
  gl.GetProgramiv(pass.program().id(), GL_ACTIVE_ATTRIBUTES, &count);
  EXPECT_EQ(count, 3);
}

// That each uniform that C++ sets is in the shader, Program::set itself sees to.
TEST_P(BodyPassTest, SetsEveryUniformOfTheShader) {
  const gl::Framebuffer framebuffer(gl, 16, 16, 1, gl::ReadMode::at_once);
  framebuffer.draw_within({0, 0, 16, 16}, {0, 0, 16, 16});
  pass.draw_inset(frame_sphere({{0, 5, 20}, 0.55, 1.5, 4.5}), Eigen::Matrix3d::Identity(),
                  {0, 0, 16, 16});
  const GLuint program = pass.program().id();
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

}  // namespace
}  // namespace twrench

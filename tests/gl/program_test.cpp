#include "gl/program.h"

#include <gmock/gmock.h>

#include <array>
#include <stdexcept>

#include "gl/context.h"
#include "gl_fixture.h"

namespace twrench::gl {
namespace {

using testing::HasSubstr;

constexpr std::array vertex_shader{
    ShaderFile{"whole.vert", "in vec3 place;\nvoid main() { gl_Position = vec4(place, 1.0); }\n"}};
constexpr ShaderFile helper{"helper.glsl",
                            "uniform float level;\nvec4 gray() { return vec4(level); }\n"};
constexpr ShaderFile whole{"whole.frag", "out vec4 color;\nvoid main() { color = gray(); }\n"};

class ProgramTest : public GlTest {
 protected:
  std::string error_of(std::span<const ShaderFile> fragment) {
    try {
      const Program program(gl, vertex_shader, fragment);
    } catch (const GlError& error) {
      return error.what();
    }
    return "no error";
  }
};

TEST_F(ProgramTest, JoinsTheFilesOfAShader) {
  const Program program(gl, vertex_shader, std::array{helper, whole});
  program.use();
  program.set("level", 0.5F);
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

TEST_F(ProgramTest, ReportsFileAndLineOfAnError) {
  const ShaderFile broken{"broken.frag", "out vec4 color;\n\nvoid main() { color = nothing; }\n"};
  EXPECT_THAT(error_of(std::array{helper, broken}), HasSubstr("broken.frag:3"));
}

TEST_F(ProgramTest, ReportsTheFileThatHasTheErrorAmongSeveral) {
  const ShaderFile broken{"broken.glsl", "vec4 gray() {\n  return vec2(1.0);\n}\n"};
  EXPECT_THAT(error_of(std::array{broken, whole}), HasSubstr("broken.glsl:2"));
}

TEST_F(ProgramTest, ReportsShadersThatDoNotLink) {
  const std::array sender{
      ShaderFile{"sender.vert",
                 "out vec2 tone;\nvoid main() { tone = vec2(1.0); gl_Position = vec4(1.0); }\n"}};
  const std::array receiver{ShaderFile{
      "receiver.frag", "in vec4 tone;\nout vec4 color;\nvoid main() { color = tone; }\n"}};
  try {
    const Program program(gl, sender, receiver);
    FAIL() << "no exception";
  } catch (const GlError& error) {
    EXPECT_THAT(error.what(), HasSubstr("sender.vert and receiver.frag"));
    EXPECT_THAT(error.what(), HasSubstr("tone"));
  }
}

TEST_F(ProgramTest, RefusesAUniformThatItHasNot) {
  const Program program(gl, vertex_shader, std::array{helper, whole});
  program.use();
  EXPECT_THROW(program.set("levle", 0.5F), std::logic_error);
}

TEST_F(ProgramTest, MovesWithoutLosingTheProgram) {
  Program first(gl, vertex_shader, std::array{helper, whole});
  const GLuint id = first.id();
  const Program second(std::move(first));
  second.use();
  EXPECT_EQ(second.id(), id);
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

}  // namespace
}  // namespace twrench::gl

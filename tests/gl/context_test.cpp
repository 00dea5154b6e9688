#include "gl/context.h"

#include <gmock/gmock.h>

#include <array>

#include "gl/functions.h"
#include "gl_fixture.h"

namespace twrench::gl {
namespace {

using ContextTest = GlTest;

TEST_F(ContextTest, IsACoreProfileOfAtLeast33) {
  GLint major = 0;
  GLint minor = 0;
  GLint profile = 0;
  gl.GetIntegerv(GL_MAJOR_VERSION, &major);
  gl.GetIntegerv(GL_MINOR_VERSION, &minor);
  gl.GetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
  EXPECT_GE(10 * major + minor, 33);
  EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT);
}

TEST_F(ContextTest, SaysWhatItIs) {
  EXPECT_THAT(context->backend(), testing::AnyOf("osmesa", "egl"));
  EXPECT_THAT(renderer_string(gl), testing::MatchesRegex(".+, OpenGL [34].+"));
}

TEST_F(ContextTest, CanBeMadeAgainAfterItIsGone) {
  context.reset();
  const auto next = make_test_context();
  EXPECT_NE(renderer_string(Functions(*next)), "");
}

struct ContextWithoutFunctions final : Context {
  void* function(const char*) const override { return nullptr; }
  std::string backend() const override { return "empty"; }
};

TEST(Functions, NamesTheOneThatIsMissing) {
  try {
    const Functions functions{ContextWithoutFunctions()};
    FAIL() << "no exception";
  } catch (const GlError& error) {
    EXPECT_STREQ(error.what(), "OpenGL: the empty context has no glGetError");
  }
}

TEST(Library, NamesWhatItLookedForAndTheRemedy) {
  constexpr std::array names{"libtwrench-none.so.2", "libtwrench-none.so"};
  try {
    const Library library(names, "install it", GlError::Reason::no_osmesa);
    FAIL() << "no exception";
  } catch (const GlError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("libtwrench-none.so.2, libtwrench-none.so"));
    EXPECT_EQ(error.remedy(), "install it");
    EXPECT_EQ(error.reason(), GlError::Reason::no_osmesa);
  }
}

TEST(Library, TakesTheFirstThatIsThere) {
  constexpr std::array names{"libtwrench-none.so", "libc.so.6"};
  const Library library(names, "");
  EXPECT_NE(library.symbol("malloc"), nullptr);
  EXPECT_EQ(library.symbol("twrench_none"), nullptr);
}

}  // namespace
}  // namespace twrench::gl

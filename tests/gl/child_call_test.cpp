#include "gl/child_call.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>

#include "gl/backend.h"
#include "gl/context.h"

namespace twrench::gl {
namespace {

using testing::HasSubstr;

/// Returns the error of the call in a child.
GlError error_of(const std::function<std::string()>& call) {
  try {
    const std::string result = ChildCall(call).result();
    return {"no error", result};
  } catch (const GlError& error) {
    return error;
  }
}

TEST(ChildCall, ReturnsWhatTheCallReturns) {
  EXPECT_EQ(ChildCall([] { return std::string("llvmpipe"); }).result(), "llvmpipe");
  const std::string large(100'000, 'x');  // more than a pipe holds
  EXPECT_EQ(ChildCall([&] { return large; }).result(), large);
}

TEST(ChildCall, ThrowsWhatTheCallThrows) {
  const GlError error = error_of(
      []() -> std::string { throw GlError("OpenGL", "x: y", "do z", GlError::Reason::no_osmesa); });
  EXPECT_STREQ(error.what(), "OpenGL: x: y");
  EXPECT_EQ(error.remedy(), "do z");
  EXPECT_EQ(error.reason(), GlError::Reason::no_osmesa);
}

TEST(ChildCall, ReportsACrash) {
  const auto segfault = [] { return ::raise(SIGSEGV) == 0 ? std::string() : "not raised"; };
  const GlError error = error_of(segfault);
  EXPECT_EQ(error.reason(), GlError::Reason::crashed);
  EXPECT_THAT(error.what(), HasSubstr("its driver crashes (signal "));
  EXPECT_NE(error.remedy(), "");
  const auto exit = []() -> std::string { ::_exit(1); };
  EXPECT_THAT(error_of(exit).what(), HasSubstr("its driver crashes (exit status 1)"));
}

TEST(ChildCall, IsKilledWhenItsOwnerDoesNotWait) {
  const ChildCall endless([]() -> std::string {
    while (true) ::pause();
  });
}

// The threads and locks of drivers do not survive a fork.
TEST(OpenContext, RefusesAForkedProcess) {
  const OpenedContext opened = open_context({});
  const GlError error = error_of([]() -> std::string {
    open_context({});
    return "opened";
  });
  EXPECT_EQ(error.reason(), GlError::Reason::forked);
  EXPECT_STREQ(error.what(), "OpenGL: this process was forked from one that has used it");
}

}  // namespace
}  // namespace twrench::gl

#include "system/memory_file.h"

#include <gtest/gtest.h>

#include "system/child_process.h"

namespace twrench::system {
namespace {

TEST(MemoryFile, IsReadByChildrenFromItsStart) {
  const std::string text(100'000, 'x');
  const MemoryFile file(text + "the end");
  for (int i = 0; i < 2; ++i) {
    ChildProcess child({"tail", "-c", "8", file.path()}, {}, ChildProcess::output_with_errors);
    EXPECT_EQ(child.wait(), 0);
    EXPECT_EQ(child.error_output(), "xthe end");
  }
}

}  // namespace
}  // namespace twrench::system

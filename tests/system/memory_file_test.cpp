#include "system/memory_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <string>

#include "system/child_process.h"

namespace twrench::system {
namespace {

TEST(MemoryFile, IsReadByAChildFromItsStart) {
  const MemoryFile file(std::string(1'000'000, 'x') + "the end");
  EXPECT_EQ(::lseek(file.descriptor(), 0, SEEK_CUR), 0);
  ChildProcess child({"tail", "-c", "8", "/dev/fd/" + std::to_string(file.descriptor())}, {},
                     ChildProcess::output_with_errors);
  EXPECT_EQ(child.wait(), 0);
  EXPECT_EQ(child.error_output(), "xthe end");
}

}  // namespace
}  // namespace twrench::system

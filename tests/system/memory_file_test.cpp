#include <gtest/gtest.h>
#include <unistd.h>

#include <string>

#include "system/child_process.h"
#include "system/descriptor.h"

namespace twrench::system {
namespace {

TEST(MemoryFile, IsReadByAChildFromItsStart) {
  const MemoryFile file(std::string(1'000'000, 'x') + "the end"), output("");
  EXPECT_EQ(::lseek(file.descriptor(), 0, SEEK_CUR), 0);
  ChildProcess child({"tail", "-c", "8", "/dev/fd/" + std::to_string(file.descriptor())}, {},
                     output.descriptor());
  EXPECT_EQ(child.wait(), 0);
  EXPECT_EQ(output.contents(), "xthe end");
}

TEST(MemoryFile, HasAllThatAChildWroteAndNoErrors) {
  const MemoryFile output("");
  ChildProcess child({"sh", "-c", "echo warning >&2; head -c 100000 /dev/zero; echo; echo end"}, {},
                     output.descriptor());
  EXPECT_EQ(child.wait(), 0);
  EXPECT_EQ(output.contents(), std::string(100'000, '\0') + "\nend\n");
  EXPECT_EQ(child.error_output(), "warning\n");
}

}  // namespace
}  // namespace twrench::system

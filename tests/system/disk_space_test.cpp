#include <gtest/gtest.h>

#include <limits>

#include "system/file.h"

namespace twrench::system {
namespace {

TEST(DiskSpace, OfAFolderThatIsStillToBeMadeIsThatOfTheOneAbove) {
  EXPECT_TRUE(on_same_disk(".", "not/made/yet"));
  EXPECT_TRUE(on_same_disk("", "."));
  EXPECT_FALSE(on_same_disk(".", "/proc"));
}

TEST(DiskSpace, IsKnown) {
  EXPECT_EQ(free_space("/proc"), 0U);
  for (const char* folder : {"", ".", "not/made/yet"}) {
    EXPECT_GT(free_space(folder), 0U) << folder;
    EXPECT_LT(free_space(folder), std::numeric_limits<std::uintmax_t>::max()) << folder;
  }
}

TEST(DiskSpace, IsSaidBriefly) {
  EXPECT_EQ(format_bytes(12), "12 bytes");
  EXPECT_EQ(format_bytes(512e3), "512 kB");
  EXPECT_EQ(format_bytes(2.85e6), "2.85 MB");
  EXPECT_EQ(format_bytes(1.66e12), "1.7 TB");
}

}  // namespace
}  // namespace twrench::system

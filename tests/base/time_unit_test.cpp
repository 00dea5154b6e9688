#include "base/time_unit.h"

#include <gtest/gtest.h>

#include <string>

namespace twrench {
namespace {

TEST(TimeUnit, GivesNumbersThatReadWell) {
  struct Case {
    double longest;
    std::string symbol;
  };
  for (const auto& [longest, symbol] :
       {Case{1e-11, "ps"}, Case{2e-9, "ns"}, Case{9e-8, "ns"}, Case{3e-7, "µs"}, Case{0.02, "ms"},
        Case{0.1, "s"}, Case{96, "s"}, Case{599, "s"}, Case{600, "min"}, Case{10799, "min"},
        Case{10800, "h"}, Case{86399, "h"}, Case{86400, "d"}, Case{1e9, "d"}}) {
    EXPECT_EQ(time_unit(longest).symbol, symbol) << longest;
  }
  EXPECT_STREQ(time_unit(1e6).name, "days");
  EXPECT_EQ(time_unit(7200).length, 60);
  EXPECT_EQ(time_unit(0).length, 1e-12);
}

}  // namespace
}  // namespace twrench

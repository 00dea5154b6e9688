#include "base/color.h"

#include <gtest/gtest.h>
#include <twrench/base/error.h>

namespace twrench {
namespace {

TEST(Color, Parses) {
  EXPECT_EQ(parse_color("#1a2B3c", "x"), (Color{0x1a, 0x2b, 0x3c}));
  EXPECT_EQ(parse_color("#f80", "x"), (Color{0xff, 0x88, 0x00}));
  EXPECT_EQ(parse_color("white", "x"), (Color{255, 255, 255}));
  EXPECT_EQ(to_string(Color{1, 171, 255}), "#01abff");
}

TEST(Color, RefusesWhatIsNone) {
  for (const char* text : {"", "#", "red", "#12345", "#1234567", "1a2b3c", "#12345g", "#-12345"}) {
    EXPECT_THROW(parse_color(text, "x"), InvalidArgument) << text;
  }
}

}  // namespace
}  // namespace twrench

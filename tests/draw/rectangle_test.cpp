#include <gtest/gtest.h>

#include "draw/view_painter.h"

namespace twrench::draw {
namespace {

TEST(Rectangle, CountsRowsFromTheBottomOfThePicture) {
  const gl::Rectangle rectangle = gl_rectangle({99, 59, 55, 35}, 260);
  EXPECT_EQ(rectangle.x, 99);
  EXPECT_EQ(rectangle.y, 260 - 59 - 35);
  EXPECT_EQ(rectangle.width, 55);
  EXPECT_EQ(rectangle.height, 35);
}

}  // namespace
}  // namespace twrench::draw

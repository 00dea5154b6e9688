#include "app/options/arguments.h"

#include <gtest/gtest.h>
#include <twrench/base/error.h>

#include <cmath>

namespace twrench::app {
namespace {

TEST(Arguments, Numbers) {
  EXPECT_EQ(parse_number("1.5e-3", "x"), 1.5e-3);
  EXPECT_EQ(parse_number("-2", "x"), -2);
  EXPECT_EQ(parse_number("+2", "x"), 2);
  EXPECT_TRUE(std::isnan(parse_number("nan", "x")));  // rejected later, by the limits
  for (const char* text : {"", "+", "+-1", "1,5", "0x10", "1 ", " 1", "1e", "one", "1e999"}) {
    EXPECT_THROW(parse_number(text, "x"), InvalidArgument) << text;
  }
}

TEST(Arguments, ListsAndVectorsAndSizes) {
  EXPECT_EQ(parse_numbers("1", "x"), std::vector<double>({1}));
  EXPECT_EQ(parse_numbers("1,-2,3.5", "x"), std::vector<double>({1, -2, 3.5}));
  EXPECT_THROW(parse_numbers("1,,2", "x"), InvalidArgument);
  EXPECT_THROW(parse_numbers("1,", "x"), InvalidArgument);
  EXPECT_EQ(parse_vector("1,2,3", "x"), Eigen::Vector3d(1, 2, 3));
  EXPECT_THROW(parse_vector("1,2", "x"), InvalidArgument);
  EXPECT_THROW(parse_vector("1,2,3,4", "x"), InvalidArgument);
  EXPECT_EQ(parse_size("640x360", "x"), Eigen::Vector2d(640, 360));
  for (const char* text : {"640", "640x", "x360", "640X360", "640x360x3"}) {
    EXPECT_THROW(parse_size(text, "x"), InvalidArgument) << text;
  }
}

}  // namespace
}  // namespace twrench::app

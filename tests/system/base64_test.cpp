#include "system/base64.h"

#include <gtest/gtest.h>

#include <vector>

namespace twrench::system {
namespace {

std::string encoded(std::string_view text) {
  return base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

// RFC 4648, section 10.
TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foo"), "Zm9v");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
}

TEST(Base64, HasNoPaddingBetweenThePieces) {
  const std::string text = encoded(std::string((3U << 20U) + 1, '\0'));
  EXPECT_EQ(text, std::string(4U << 20U, 'A') + "AA==");
}

}  // namespace
}  // namespace twrench::system

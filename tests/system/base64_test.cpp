#include <gtest/gtest.h>

#include <vector>

#include "system/bytes.h"

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
  const std::string text = encoded(std::string((9U << 20U) + 1, '\0'));
  EXPECT_TRUE(text == std::string(12U << 20U, 'A') + "AA==");  // too long to be printed
}

std::string decoded(const std::string& text) {
  const auto bytes = bytes_of_base64(text);
  return bytes ? std::string(bytes->begin(), bytes->end()) : "no base64";
}

TEST(Base64, IsReadBack) {
  for (const char* text : {"", "f", "fo", "foo", "foobar"}) EXPECT_EQ(decoded(encoded(text)), text);
  std::string large((3U << 20U) + 4, 'x');
  large[3U << 20U] = '\0';
  for (int i = 0; i < 3; ++i, large += '\xff') EXPECT_TRUE(decoded(encoded(large)) == large) << i;
}

TEST(Base64, ThatIsNoneIsNothing) {
  for (const char* text : {"Zg=", "Zg", "Z===", "Zg==Zg==", "Zm9v\n", "Zm 9v", " Zm9v===", "Zm9-",
                           "=m9v", "Zm9v Zm9v  ="}) {
    EXPECT_EQ(decoded(text), "no base64") << text;
  }
}

}  // namespace
}  // namespace twrench::system

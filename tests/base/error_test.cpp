#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>

#include <string>

namespace twrench {
namespace {

using testing::EndsWith;
using testing::StartsWith;

TEST(Error, IsNotCutByANul) {
  const std::string name("a\0b", 3);
  EXPECT_STREQ(Error(name, "is no name").what(), "a\\x00b: is no name");
  EXPECT_EQ(InvalidArgument(name, "is no name", name).quantity(), "a\\x00b");
  EXPECT_EQ(InvalidArgument(name, "is no name", name).remedy(), "a\\x00b");
}

TEST(Error, LeavesOutTheMiddleOfALongText) {
  const Error error("begin" + std::string(1'000'000, 'x') + "end", std::string(10'000, 'y'));
  const std::string message = error.what();
  EXPECT_LT(message.size(), 2100U);
  EXPECT_THAT(message, StartsWith("beginxxx"));
  EXPECT_THAT(message.substr(0, message.find(": ")), EndsWith("xxxend"));
  const std::string longest(1000, 'x');
  EXPECT_EQ(Error(longest, "why").what(), longest + ": why");
}

TEST(Error, LeavesOutWholeCharacters) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "\u20ac";  // three bytes each
  std::string message = Error("x" + text, "why").what();
  for (std::size_t at = 0; (at = message.find("\u20ac", at)) != std::string::npos;) {
    message.erase(at, 3);
  }
  EXPECT_EQ(message, "x\u2026: why");
}

TEST(Error, ShortensWhatItQuotes) {
  const std::string typed = std::string(39, 'a') + std::string(70'000, 'b') + std::string(39, 'c');
  const std::string shown = std::string(39, 'a') + "\u2026" + std::string(39, 'c');
  EXPECT_EQ(Error("--step", "'" + typed + "' is not a number").what(),
            "--step: '" + shown + "' is not a number");
  EXPECT_EQ(Error("frames '" + typed + "'", "not '" + typed + "', the body's").what(),
            "frames '" + shown + "': not '" + shown + "', the body's");
  const std::string longest(80, 'x');
  EXPECT_EQ(Error("a", "unknown name '" + longest + "'").what(),
            "a: unknown name '" + longest + "'");
}

TEST(Error, ShortensAQuotationByWholeLetters) {
  std::string typed, kept;
  for (int i = 0; i < 81; ++i) typed += "\u20ac";  // three bytes each
  for (int i = 0; i < 39; ++i) kept += "\u20ac";
  EXPECT_EQ(Error("a", "'" + typed + "' is unknown").what(),
            "a: '" + kept + "\u2026" + kept + "' is unknown");
}

TEST(Error, LeavesAPathWhole) {
  const std::string path = "folder/" + std::string(200, 'x') + ".toml";
  EXPECT_EQ(Error("a", "'" + path + "' is a folder").what(), "a: '" + path + "' is a folder");
}

// Callers use the length of the quantity to split the message.
TEST(Error, BeginsWithItsQuantity) {
  const InvalidArgument error(std::string(5000, 'q'), "why");
  EXPECT_EQ(error.what(), error.quantity() + ": why");
  EXPECT_EQ(InvalidArgument(error.quantity(), "why").quantity(), error.quantity());
}

}  // namespace
}  // namespace twrench

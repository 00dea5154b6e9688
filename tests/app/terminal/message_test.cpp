#include "app/terminal/message.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace twrench::app {
namespace {

TEST(FormatMessage, EscapesValuesAndNotItsFormat) {
  const std::string name = "a\nb";
  EXPECT_EQ(format_message("{}: {:.1f}\n{}\n", name, 1.25, "\x1b"), "a\\nb: 1.2\n\\x1b\n");
  EXPECT_EQ(format_message("{:<6}|", std::string("\n")), "\\n    |");
}

TEST(Warn, IsAsciiOnOneLineOfJsonWhateverTheText) {
  testing::internal::CaptureStderr();
  warn("a\n\u202e\x7f\xff\"", true);
  std::string line = testing::internal::GetCapturedStderr();
  EXPECT_EQ(line.back(), '\n');
  line.pop_back();
  for (const char c : line) EXPECT_TRUE(c >= ' ' && c < '\x7f') << int{c};
  EXPECT_EQ(nlohmann::json::parse(line)["warning"], "a\n\u202e\x7f\ufffd\"");
}

}  // namespace
}  // namespace twrench::app

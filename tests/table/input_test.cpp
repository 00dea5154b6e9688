#include "table/input.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <string>

#include "scratch_folder.h"
#include "system/error.h"
#include "table/read_table.h"

namespace twrench::table {
namespace {

using namespace std::string_view_literals;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::string refusal(const std::filesystem::path& path) {
  try {
    open_table(path);
  } catch (const system::FileError& error) {
    return std::string(error.what()) + " -- " + error.remedy();
  }
  return "no error";
}

TEST(Input, IsAFile) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "run.csv") << "t,w\n0,1\n";
  const auto reader = open_table(scratch / "run.csv");
  EXPECT_THAT(reader->header().names, ElementsAre("t", "w"));
  EXPECT_EQ(reader->header().file, (scratch / "run.csv").string());
}

TEST(Input, IsNothingElse) {
  const ScratchFolder scratch;
  EXPECT_THAT(refusal(scratch / "none.csv"), HasSubstr("No such file"));
  EXPECT_THAT(refusal(scratch.path()), HasSubstr("Is a directory"));
  EXPECT_THAT(refusal("/dev/zero"), HasSubstr("not a regular file"));
  ASSERT_EQ(::mkfifo((scratch / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(refusal(scratch / "pipe"), HasSubstr("not a regular file"));
  EXPECT_THROW(open_table(std::filesystem::path("-")), InvalidArgument);
}

TEST(Input, SaysWhatIsNoTable) {
  EXPECT_THAT(file_error_of("\x1F\x8B\x08"),
              AllOf(HasSubstr("compressed by gzip"), HasSubstr("gunzip")));
  EXPECT_THAT(file_error_of("PK\x03\x04"), HasSubstr("ZIP archive is cut off or damaged"));
  EXPECT_THAT(file_error_of(std::string_view("t\0,\0w\0\n\0", 8)), HasSubstr("UTF-16"));
  EXPECT_THAT(file_error_of(std::string_view("t\0,\0", 4)), HasSubstr("binary"));
  for (const auto& [bytes, kind] :
       {std::pair<std::string_view, const char*>("\xFF\xD8\xFF\xE0", "the file is a JPEG picture"),
        {"\x89PNG\r\n\x1A\n", "a PNG picture"},
        {"GIF89a\1", "a GIF picture"},
        {"<!DOCTYPE html>\n<p>1,2</p>\n", "an HTML page"},
        {"<html>\n", "an HTML page"},
        {"%PDF-1.7\n1 2\n", "a PDF document"},
        {"\xFD\x37zXZ\0"sv, "compressed by xz"},
        {"", "the file is empty"}}) {
    EXPECT_THAT(file_error_of(bytes), HasSubstr(kind));
  }
  EXPECT_EQ(read_table("ID3,BZh\n0,1\n").rows.size(), 1U);
  std::string wide = "a";
  for (int i = 0; i < 16384; ++i) wide += ",a";
  EXPECT_THAT(file_error_of(wide + "\n" + wide + "\n1\n"), HasSubstr("it has 16385 columns"));
}

// Requests near the ends of the buffer and of the input.
TEST(Window, ShowsTheBytesAskedFor) {
  std::string bytes;
  for (int i = 0; i < 400'000; ++i) bytes += static_cast<char>('a' + i % 26);
  const Input input("run", bytes);
  Window window(input);
  for (const std::size_t offset :
       {0U, 262'140U, 262'144U, 262'150U, 399'995U, 5U, 400'000U, 500'000U}) {
    const std::string expected = offset < bytes.size() ? bytes.substr(offset, 10) : "";
    EXPECT_EQ(window.at(offset, 10), expected) << offset;
  }
}

/// The text in UTF-16 with its byte order mark.
std::string in_utf16(std::u16string_view text, bool big_endian) {
  std::string bytes;
  const auto add = [&](char16_t unit) {
    const char high = static_cast<char>(unit >> 8), low = static_cast<char>(unit & 0xFF);
    bytes += big_endian ? high : low;
    bytes += big_endian ? low : high;
  };
  add(0xFEFF);
  for (const char16_t unit : text) add(unit);
  return bytes;
}

TEST(Input, ConvertsUtf16) {
  for (const bool big_endian : {false, true}) {
    const Table table =
        read_table(in_utf16(u"t (\u00b5s)\twx \U0001D714\r\n0\t1.5\r\n1\t2.5\r\n", big_endian));
    EXPECT_EQ(table.names, (std::vector<std::string>{"t (\u00b5s)", "wx \U0001D714"}));
    EXPECT_EQ(table.rows, (std::vector<std::vector<double>>{{0, 1.5}, {1, 2.5}}));
  }
}

// A character whose two units are in different blocks of the file.
TEST(Input, ConvertsLongUtf16) {
  std::u16string text = u"t,wx\n";
  while (text.size() < 400'000) text += u"# \U0001D714\U0001D714 \n";
  EXPECT_EQ(read_table(in_utf16(text + u"1,2\n", false)).rows,
            (std::vector<std::vector<double>>{{1, 2}}));
}

TEST(Input, RefusesBrokenUtf16) {
  std::string cut = in_utf16(u"t,wx\n0,1\n1,2", false);
  cut.pop_back();
  EXPECT_THAT(file_error_of(cut), HasSubstr("ends within a character"));
  EXPECT_THAT(file_error_of(in_utf16(u"t,wx\n0,\xDC00", true)),
              HasSubstr("invalid character at byte 16"));
  EXPECT_THAT(file_error_of(in_utf16(u"", true)), HasSubstr("the file is empty"));
}

}  // namespace
}  // namespace twrench::table

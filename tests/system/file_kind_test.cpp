#include "system/file_kind.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace twrench::system {
namespace {

using namespace std::string_literals;

std::string kind_of(const std::string& bytes) {
  return std::string(recognized_file_kind(bytes).value_or("unknown"));
}

/// Returns the text in UTF-16 without a byte order mark.
std::string utf16(const std::string& ascii, bool big_endian) {
  std::string text;
  for (const char c : ascii) text += big_endian ? std::string{'\0', c} : std::string{c, '\0'};
  return text;
}

TEST(FileKind, IsThatOfTheFirstBytes) {
  const std::vector<std::pair<std::string, std::string>> files{
      {"", "empty"},
      {"\x89PNG\r\n\x1A\n\0\0\0\rIHDR"s, "a PNG picture"},
      {"\xFF\xD8\xFF\xE0\0\x10JFIF"s, "a JPEG picture"},
      {"GIF89a\1\0\1\0"s, "a GIF picture"},
      {"RIFF\x24\0\0\0WEBPVP8 "s, "a WebP picture"},
      {"II*\0\x08\0\0\0"s, "a TIFF picture"},
      {"MM\0*\0\0\0\x08"s, "a TIFF picture"},
      {"BM\x46\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0"s, "a BMP picture"},
      {"%PDF-1.7\n", "a PDF document"},
      {"Kaydara FBX Binary  \0\x1A\0"s, "an FBX model"},
      {"; FBX 7.7.0 project file\n", "an FBX model"},
      {"ISO-10303-21;\nHEADER;", "a STEP model"},
      {"PK\3\4\x14\0"s, "a ZIP archive"},
      {"PK\3\4\x14\0\6\0\x08\0 ... 3D/3dmodel.model"s, "a 3MF model, which is a ZIP archive"},
      {"\x1F\x8B\x08\0\0"s, "compressed by gzip"},
      {"RIFF\x24\0\0\0WAVEfmt "s, "a WAV sound"},
      {"\0\0\0\x20"
       "ftypisom"s,
       "an MP4 or QuickTime film"},
      {"<!DOCTYPE html>\n<html>", "an HTML page"},
      {"\xEF\xBB\xBF\r\n  <HTML lang=en>", "an HTML page"},
      {"<?xml version=\"1.0\"?>", "an XML document"},
      {"version https://git-lfs.github.com/spec/v1\noid sha256:0\n",
       "a pointer to a file in Git LFS, not the file itself"},
      {"\xFF\xFE" + utf16("v 0", false), "text in UTF-16, not in UTF-8"},
      {"\xFE\xFF" + utf16("v 0", true), "text in UTF-16, not in UTF-8"},
      {utf16("t,wx,wy\r\n", false), "text in UTF-16, not in UTF-8"},
      {utf16("t,wx,wy\r\n", true), "text in UTF-16, not in UTF-8"}};
  for (const auto& [bytes, kind] : files) EXPECT_EQ(kind_of(bytes), kind) << bytes;
}

TEST(FileKind, OfOrdinaryTextIsUnknown) {
  for (const char* text :
       {"v 0 0 0\n", "solid a\n", "ply\n", "t,wx,wy,wz\n", "{\"asset\": {}}", "BM,GIF,PK\n",
        "# made by hand\n", "<a> b\n", "\xEF\xBB\xBFv 0 0 0\n", "I", " ", "MMMMMMMMMMMMMMMMMMMM"}) {
    EXPECT_EQ(kind_of(text), "unknown") << text;
  }
  EXPECT_EQ(kind_of(std::string(84, '\0')), "unknown");
  EXPECT_EQ(kind_of("v\0 \0"s), "unknown") << "too short to be called UTF-16";
}

TEST(ByteOrderMark, IsRemovedOnce) {
  EXPECT_EQ(without_byte_order_mark("\xEF\xBB\xBFv 0"), "v 0");
  EXPECT_EQ(without_byte_order_mark("\xEF\xBB\xBF\xEF\xBB\xBF"), "\xEF\xBB\xBF");
  EXPECT_EQ(without_byte_order_mark("v 0"), "v 0");
  EXPECT_EQ(without_byte_order_mark("\xEF\xBB"), "\xEF\xBB");
}

}  // namespace
}  // namespace twrench::system

#include "text/escape.h"

#include <gtest/gtest.h>

#include <string_view>

namespace twrench::text {
namespace {

TEST(Escape, LeavesWhatCanBeRead) {
  for (const char* text :
       {"", "a b-c_d.toml", "C:\\x", "omega \u03c9 \u65e5\u672c \U0001f6f0", "'\"`$"}) {
    EXPECT_EQ(escape(text), text);
  }
}

TEST(Escape, ShowsControlCharacters) {
  EXPECT_EQ(escape("a\nb\r\tc"), "a\\nb\\r\\tc");
  EXPECT_EQ(escape("\x1b[2J\x07\x7f"), "\\x1b[2J\\x07\\x7f");
  EXPECT_EQ(escape(std::string_view("\0x", 2)), "\\x00x");
  EXPECT_EQ(escape("\u009b2J\u0085"), "\\u009b2J\\u0085");  // C1, which some terminals obey
}

TEST(Escape, ShowsWhatTurnsOrHidesText) {
  EXPECT_EQ(escape("a\u202egnp.toml"), "a\\u202egnp.toml");
  EXPECT_EQ(escape("\u2066\u2069\u200b\u200f\ufeff\u2028\u00ad\u061c"),
            "\\u2066\\u2069\\u200b\\u200f\\ufeff\\u2028\\u00ad\\u061c");
  EXPECT_EQ(escape("\U000e0041"), "\\U000e0041");
}

TEST(Escape, ShowsBytesThatAreNoUtf8) {
  EXPECT_EQ(escape("a\xff\xc3"), "a\\xff\\xc3");
  EXPECT_EQ(escape("\x9b"), "\\x9b");
  EXPECT_EQ(escape("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // a surrogate
  EXPECT_EQ(escape("\ufffd"), "\ufffd");                 // is itself well-formed
}

TEST(WithReferences, ReplacesOnlyTheMarkup) {
  EXPECT_EQ(with_references("<a>\n\"&\""), "&lt;a&gt;\n&quot;&amp;&quot;");
  EXPECT_EQ(with_references("<a> \"&\"", "&<>"), "&lt;a&gt; \"&amp;\"");
}

TEST(EscapeXml, HasReferencesForMarkup) {
  EXPECT_EQ(escape_xml("<a href=\"x\">'&amp;"), "&lt;a href=&quot;x&quot;&gt;'&amp;amp;");
  EXPECT_EQ(escape_xml("frame 1 \u03c9.png"), "frame 1 \u03c9.png");
}

TEST(EscapeXml, ShowsWhatXmlDoesNotAllow) {
  EXPECT_EQ(escape_xml("a\x01\n\xff"), "a\\x01\\n\\xff");
  EXPECT_EQ(escape_xml("\uffff<\ufffe"), "\\uffff&lt;\\ufffe");
}

}  // namespace
}  // namespace twrench::text

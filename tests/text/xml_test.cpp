#include "text/xml.h"

#include <gtest/gtest.h>

namespace twrench::text {
namespace {

TEST(EscapeXml, HasReferencesForMarkup) {
  EXPECT_EQ(escape_xml("<a href=\"x\">'&amp;"), "&lt;a href=&quot;x&quot;&gt;&#39;&amp;amp;");
  EXPECT_EQ(escape_xml("frame 1 \u03c9.png"), "frame 1 \u03c9.png");
}

TEST(EscapeXml, ShowsWhatXmlDoesNotAllow) {
  EXPECT_EQ(escape_xml("a\x01\n\xff"), "a\\x01\\n\\xff");
  EXPECT_EQ(escape_xml("\uffff<\ufffe"), "\\uffff&lt;\\ufffe");
}

}  // namespace
}  // namespace twrench::text

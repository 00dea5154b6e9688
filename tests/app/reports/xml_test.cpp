#include "app/reports/xml.h"

#include <gtest/gtest.h>

namespace twrench::app {
namespace {

TEST(XmlText, HasReferencesForMarkup) {
  EXPECT_EQ(xml_text("<a href=\"x\">'&amp;"), "&lt;a href=&quot;x&quot;&gt;&#39;&amp;amp;");
  EXPECT_EQ(xml_text("frame 1 \u03c9.png"), "frame 1 \u03c9.png");
}

TEST(XmlText, ShowsWhatXmlDoesNotAllow) {
  EXPECT_EQ(xml_text("a\x01\n\xff"), "a\\x01\\n\\xff");
  EXPECT_EQ(xml_text("\uffff<\ufffe"), "\\uffff&lt;\\ufffe");
}

}  // namespace
}  // namespace twrench::app

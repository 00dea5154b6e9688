#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "report/file.h"

namespace twrench::report {
namespace {

TEST(Html, LetsThePageRunSaveAndCopyInItsFrame) {
  const Viewer viewer{.page = "<p title=\"a\">", .policy = "<meta>", .poster = "<img>"};
  std::string text;
  write_html({}, &viewer, [&](std::string_view piece) { text += piece; });
  EXPECT_THAT(text, testing::HasSubstr("<meta>"));
  EXPECT_THAT(text,
              testing::HasSubstr(
                  "<img><iframe title=\"The motion\" sandbox=\"allow-scripts allow-downloads\" "
                  "allow=\"clipboard-write\" srcdoc=\"&lt;p title=&quot;a&quot;&gt;\"></iframe>"));
}

}  // namespace
}  // namespace twrench::report

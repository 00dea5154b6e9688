#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "comparison/report.h"

namespace twrench::comparison {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

/// In three frames, 0, 1 and 100 of 10,000 pixels differ.
Comparison three_frames(double share) {
  Comparison comparison;
  comparison.criteria.share = share;
  comparison.frames = {{.name = "0.png"}, {.name = "1.png"}, {.name = "2.png"}};
  for (const std::size_t i : {std::size_t{1}, std::size_t{2}}) {
    FrameResult& frame = comparison.frames[i];
    frame.difference.share = i == 1 ? 1e-4 : 1e-2;
    frame.outcome = frame.difference.share > share ? Outcome::different : Outcome::alike;
  }
  return comparison;
}

// From 1 at the top, y = 0, to a millionth at y = 100.
TEST(DifferenceChart, HasBarsAndTheBoundOnOneScale) {
  const std::string chart = difference_chart(three_frames(1e-3));
  EXPECT_THAT(chart, HasSubstr(R"(class="bound" d="M0 50H3")"));
  EXPECT_THAT(chart, ContainsRegex(R"(class="within" d="M1\.3[89] 66\.67h)"));
  EXPECT_THAT(chart, ContainsRegex(R"(class="over" d="M2\.3[89] 33\.33h)"));
  EXPECT_THAT(difference_chart(three_frames(0.1)), HasSubstr(R"(class="bound" d="M0 16.67H3")"));
  EXPECT_THAT(difference_chart(three_frames(0)), Not(HasSubstr("class=\"bound\"")));
}

}  // namespace
}  // namespace twrench::comparison

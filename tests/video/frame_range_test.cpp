#include "video/frame_range.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>

#include <string>
#include <vector>

namespace twrench::video {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(FrameRange, OneFrame) { EXPECT_THAT(parse_frame_range("7", 10), ElementsAre(7)); }

TEST(FrameRange, BothEndsAreIncluded) {
  EXPECT_THAT(parse_frame_range("3-6", 10), ElementsAre(3, 4, 5, 6));
  EXPECT_THAT(parse_frame_range("0-0", 1), ElementsAre(0));
  EXPECT_THAT(parse_frame_range("8-9", 10), ElementsAre(8, 9));
}

TEST(FrameRange, AStepNeedNotMeetTheEnd) {
  EXPECT_THAT(parse_frame_range("1-9:4", 10), ElementsAre(1, 5, 9));
  EXPECT_THAT(parse_frame_range("1-8:4", 10), ElementsAre(1, 5));
  EXPECT_THAT(parse_frame_range("1-8:2147483647", 10), ElementsAre(1));
}

TEST(FrameRange, PartsAreJoinedSortedAndTakenOnce) {
  EXPECT_THAT(parse_frame_range("8,0-2,2-6:2,1", 10), ElementsAre(0, 1, 2, 4, 6, 8));
}

TEST(FrameRange, RefusesWhatIsNone) {
  for (const char* range : {"",
                            ",",
                            "1,",
                            ",1",
                            "a",
                            "1-",
                            "-1",
                            "--1",
                            "1--2",
                            "1-2-3",
                            "1:2",
                            "1-2:",
                            "1-2:0",
                            "1-2:-1",
                            "2-1",
                            " 1",
                            "1 ",
                            "+1",
                            "1-2:1:1",
                            "0x1",
                            "1.0",
                            "99999999999",
                            "0-99999999999999999999",
                            "1\n"}) {
    EXPECT_THROW(parse_frame_range(range, 10), InvalidArgument) << range;
  }
}

TEST(FrameRange, SaysWhichPartIsWrong) {
  try {
    parse_frame_range("1-2,5-3,x", 10);
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_STREQ(error.what(), "frames '1-2,5-3,x': '5-3' is not a frame or a range of frames");
    EXPECT_THAT(error.remedy(), HasSubstr("a-b:step"));
  }
}

TEST(FrameRange, SaysWhichFramesThereAre) {
  try {
    parse_frame_range("3-10", 10);
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_STREQ(error.what(), "frames '3-10': there is no frame 10");
    EXPECT_EQ(error.remedy(), "the video's frames are 0-9");
  }
  EXPECT_THROW(parse_frame_range("0-2147483647", max_frame_count), InvalidArgument);
}

TEST(FrameRange, OfTheLargestFilmIsHeld) {
  EXPECT_EQ(parse_frame_range("0-9999999", max_frame_count).size(), 10'000'000U);
}

TEST(FrameRange, DoesNotSelectTheSameFramesWithoutEnd) {
  std::string range = "0-9999999";
  for (int i = 0; i < 10; ++i) range += ",0-9999999";
  EXPECT_THROW(parse_frame_range(range, max_frame_count), InvalidArgument);
}

TEST(FrameRange, IsFormattedAsBrieflyAsItIsRead) {
  EXPECT_EQ(format_frame_range({}), "");
  for (const std::string range : {"4", "0-3", "0-3,7", "1,3,5-6,9"}) {
    EXPECT_EQ(format_frame_range(parse_frame_range(range, 10)), range);
  }
}

TEST(FrameRange, IsShortInAMessage) {
  std::vector<int> even;
  for (int i = 0; i < 1000; i += 2) even.push_back(i);
  const std::string brief = brief_frame_range(even);
  EXPECT_LT(brief.size(), 150U);
  EXPECT_THAT(brief, ::testing::StartsWith("0,2,4,"));
  EXPECT_THAT(brief, ::testing::EndsWith(",... (500 in all)"));
  EXPECT_EQ(brief_frame_range(std::vector<int>{1, 2, 3, 7}), "1-3,7");
}

}  // namespace
}  // namespace twrench::video

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "cli/twrench.h"
#include "system/file.h"

namespace twrench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

int count_of(const std::string& part, const std::string& text) {
  int count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++count;
  return count;
}

/// The number of dashed lines, which mark flips.
int dashes(const std::string& svg) { return count_of("stroke-dasharray", svg); }

TEST(Plot, NinePanelsWithTheFlipsMarked) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, "plot -o a.svg");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out + run.err, "");
  const std::string svg = text_of(folder / "a.svg");
  for (int i = 1; i <= 3; ++i) {
    for (int j = 1; j <= 3; ++j)
      EXPECT_THAT(svg, HasSubstr(std::to_string(10 * i + j) + "</tspan>"));
  }
  EXPECT_THAT(svg, HasSubstr("The Dzhanibekov effect"));
  EXPECT_THAT(svg, HasSubstr(">flips<"));
  EXPECT_EQ(count_of("t (s)", svg), 3);
  EXPECT_GE(dashes(svg), 9) << "one in each panel at least";
}

TEST(Plot, ExplainsItsLinesInTheTopMargin) {
  const ScratchFolder folder;
  EXPECT_EQ(run_twrench(folder, "plot -o a.svg").code, 0);
  const std::string svg = text_of(folder / "a.svg");
  std::smatch key;
  ASSERT_TRUE(std::regex_search(
      svg, key, std::regex(R"(translate\([-.\d]+,([-.\d]+)\)[^>]*>\s*<text>flips<)")));
  EXPECT_GT(std::stod(key[1]), 14);
  EXPECT_LT(std::stod(key[1]), 42);
}

TEST(Plot, AWobbleHasNoFlipsToMark) {
  const ScratchFolder folder;
  EXPECT_EQ(run_twrench(folder, "plot stable-z -o a.svg").code, 0);
  EXPECT_THAT(text_of(folder / "a.svg"), Not(HasSubstr(">flips<")));
  EXPECT_EQ(dashes(text_of(folder / "a.svg")), 0);
}

TEST(Plot, SeveralScenesTogether) {
  const ScratchFolder folder;
  EXPECT_EQ(run_twrench(folder, "plot dzhanibekov stable-y stable-z -o a.svg").code, 0);
  const std::string svg = text_of(folder / "a.svg");
  for (const char* title : {"The Dzhanibekov effect", "Stable rotation about y",
                            "Stable rotation about z", "flips of The Dzhanibekov effect"}) {
    EXPECT_THAT(svg, HasSubstr(title));
  }
}

TEST(Plot, OfAnotherBodyHasANeutralTitle) {
  const ScratchFolder folder;
  EXPECT_EQ(run_twrench(folder, "plot --inertia 3,5,7 -o a.svg").code, 0);
  EXPECT_THAT(text_of(folder / "a.svg"),
              AllOf(HasSubstr(">A free rigid body<"), Not(HasSubstr("Dzhanibekov"))));
  EXPECT_EQ(run_twrench(folder, "plot dzhanibekov stable-y --inertia 3,5,7 -o a.svg").code, 0);
  EXPECT_THAT(text_of(folder / "a.svg"), AllOf(HasSubstr(">A free rigid body: dzhanibekov<"),
                                               HasSubstr(">A free rigid body: stable-y<")));
}

TEST(Plot, OverlayHasOnePanelForEachColumnAndScene) {
  const ScratchFolder folder;
  EXPECT_EQ(run_twrench(folder, "plot --overlay dzhanibekov stable-y -o a.svg").code, 0);
  const std::string svg = text_of(folder / "a.svg");
  EXPECT_THAT(svg, HasSubstr("x in space"));
  EXPECT_THAT(svg, HasSubstr("Stable rotation about y"));
  EXPECT_EQ(count_of("t (s)", svg), 3);
}

TEST(Plot, MotionOptionsApply) {
  const ScratchFolder folder;
  EXPECT_EQ(run_twrench(folder, "plot --duration 10 -o short.svg").code, 0);
  EXPECT_THAT(text_of(folder / "short.svg"), Not(HasSubstr(">flips<"))) << "the first is at 11.8 s";
  EXPECT_EQ(run_twrench(folder, "plot --duration 12 --method exact -o a.pdf").code, 0);
  EXPECT_EQ(run_twrench(folder, "plot --duration 12 --omega 0,0,0 -o a.png").code, 0);
}

TEST(Plot, ATitleIsShownAsItIs) {
  const ScratchFolder folder;
  system::write_file_atomically(folder / "s.toml",
                                "title = 'a_b^2 \"`ls`\" {x} é'\n[body]\nmoments = [2, 3, 4]\n");
  EXPECT_EQ(run_twrench(folder, "plot s.toml -o a.svg", "LC_ALL=C ").code, 0);
  EXPECT_THAT(text_of(folder / "a.svg"), HasSubstr("a_b^2"));
  EXPECT_THAT(text_of(folder / "a.svg"), HasSubstr("`ls`"));
  EXPECT_THAT(text_of(folder / "a.svg"), HasSubstr("{x} é"));
}

TEST(Plot, GnuplotIsMissedBeforeAnythingRuns) {
  const ScratchFolder folder;
  for (const char* command : {"plot -o a.svg", "study --plot a.svg"}) {
    const Outcome run = run_twrench(folder, command, "PATH=/nowhere ");
    EXPECT_EQ(run.code, 4) << command;
    EXPECT_THAT(run.err,
                HasSubstr("twrench: error: cannot start gnuplot: it was not found in PATH"));
    EXPECT_THAT(run.err, HasSubstr("apt-get install gnuplot-nox"));
    EXPECT_EQ(run.out, "");
  }
}

TEST(Plot, LeavesNothingElseBehind) {
  const ScratchFolder folder;
  run_twrench(folder, "plot --duration 10 -o a.svg");
  EXPECT_THAT(folder.names(), testing::UnorderedElementsAre("a.svg", "stdout.txt", "stderr.txt"));
}

}  // namespace
}  // namespace twrench

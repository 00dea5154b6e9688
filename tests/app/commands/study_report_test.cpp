#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/commands/commands.h"
#include "motion/reference.h"

namespace twrench::app {
namespace {

using testing::HasSubstr;

/// A successful run and a failed one.
study::Study small_study() {
  study::StudyPlan plan{
      {&motion::find_method("rkmk45"), &motion::find_method("rkmk4")}, {50}, {1e-8}, 0.1, 60};
  return study::run_study(motion::reference_case("wrench-a").body, plan);
}

TEST(StudyReport, TextHasEverythingForPeople) {
  const std::string text = study_text(small_study(), "wrench");
  EXPECT_THAT(text, HasSubstr("wrench: 60 s of motion"));
  EXPECT_THAT(text, HasSubstr("every 23.630725246383 s"));
  EXPECT_THAT(text, HasSubstr("23.618730497761 s"));
  EXPECT_THAT(text, HasSubstr("longer than a turn of the body"));
  EXPECT_THAT(text, HasSubstr("true/E, median"));
  EXPECT_THAT(text, HasSubstr("59.07681"));
}

TEST(StudyReport, TextOfAMotionWithoutFlips) {
  study::StudyPlan plan{{&motion::find_method("rkmk4")}, {0.1}, {}, 0.1, 10};
  const std::string text =
      study_text(study::run_study(motion::reference_case("sphere").body, plan), "sphere");
  EXPECT_THAT(text, HasSubstr("Flips: none"));
  EXPECT_THAT(text, testing::Not(HasSubstr("Flip times")));
}

TEST(StudyReport, TextOfTheSeparatrix) {
  study::StudyPlan plan{{&motion::find_method("rkmk4")}, {0.1}, {}, 0.1, 10};
  const motion::FreeBody body(Eigen::Vector3d(1, 4, 6).asDiagonal(), {2, 0, 1});
  const std::string text = study_text(study::run_study(body, plan), "separatrix");
  EXPECT_THAT(text, HasSubstr("Flips: at most one"));
  EXPECT_THAT(text, testing::Not(HasSubstr("inf")));
}

TEST(StudyReport, CsvHasTheSameNumberOfCellsInEveryLine) {
  std::istringstream lines(study_csv(small_study()));
  std::string header, line;
  std::getline(lines, header);
  EXPECT_THAT(header, testing::StartsWith("method,order_seen,step,tolerance,early_error,error,"));
  int count = 0;
  for (; std::getline(lines, line); ++count) {
    EXPECT_EQ(std::ranges::count(line, ','), std::ranges::count(header, ',')) << line;
  }
  EXPECT_EQ(count, 2);
}

TEST(StudyReport, JsonHasTheNumbersAndNullWhereThereIsNone) {
  const study::Study study = small_study();
  const auto document = nlohmann::json::parse(study_json(study, "wrench"));
  EXPECT_EQ(document["scene"], "wrench");
  EXPECT_EQ(document["flips"]["times"].size(), 3U);
  const auto& run = document["methods"][0]["runs"][0];
  EXPECT_EQ(run["tolerance"], 1e-8);
  EXPECT_EQ(run["error"], study.methods[0].runs[0].error);
  EXPECT_EQ(run["estimate"]["median_ratio"], study.methods[0].runs[0].estimate->median_ratio);
  EXPECT_TRUE(document["methods"][1]["order_seen"].is_null());
  EXPECT_THAT(document["methods"][1]["runs"][0]["failure"].get<std::string>(),
              HasSubstr("longer than a turn"));
}

}  // namespace
}  // namespace twrench::app

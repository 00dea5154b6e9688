#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "plot/plots.h"

namespace twrench::plot {
namespace {

/// Every method that has steps, with errors computed from its order and a coefficient near 1.
study::Study study_of_all() {
  study::Study study;
  study.duration = 20, study.early = 10;
  double coefficient = 1;
  for (const motion::Method& method : motion::methods()) {
    if (method.exact()) continue;
    study::MethodStudy m{&method, {}, method.order, {}};
    coefficient *= 1.1;
    for (double step = 0.0015; step < 0.3; step *= 2) {
      study::StudyRun run;
      run.step = step;
      run.early_error = std::max(1e-13, coefficient * std::pow(step, method.order.value_or(4)));
      run.error = 2 * run.early_error;
      run.cpu_seconds = 1e-4 / step;
      run.drift_in_time.assign(20, run.error);
      m.runs.push_back(run);
    }
    m.order = 4;
    study.methods.push_back(m);
  }
  return study;
}

std::vector<std::smatch> matches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  return {std::sregex_iterator(text.begin(), text.end(), regex), std::sregex_iterator()};
}

TEST(StudyPlot, GivesEveryMethodAColourAndASymbolOfItsOwn) {
  const study::Study study = study_of_all();
  ASSERT_GE(study.methods.size(), 11U);
  const std::string script = study_plot(study).script;
  std::set<std::string> colors, symbols;
  for (const std::smatch& entry :
       matches(script, "keyentry with linespoints lw 1.5 lc rgb '(#[0-9A-F]+)' pt (\\d+)")) {
    EXPECT_TRUE(colors.insert(entry[1]).second) << entry[1];
    EXPECT_TRUE(symbols.insert(entry[2]).second) << entry[2];
  }
  EXPECT_EQ(colors.size(), study.methods.size());
}

TEST(StudyPlot, HasTimesInAUnitThatReadsWell) {
  study::Study study = study_of_all();
  EXPECT_THAT(study_plot(study).script, testing::AllOf(testing::HasSubstr("set xlabel 't (s)'"),
                                                       testing::HasSubstr("error of X at 10 s'")));
  study.duration = 20 * 86400, study.early = 2 * 3600;
  EXPECT_THAT(study_plot(study).script, testing::AllOf(testing::HasSubstr("set xlabel 't (days)'"),
                                                       testing::HasSubstr("set xrange [0:20]"),
                                                       testing::HasSubstr("error of X at 120 min'"),
                                                       testing::HasSubstr("error of X at 20 d'")));
  EXPECT_THAT(study_plot(study, scene::Language::nb).script,
              testing::AllOf(testing::HasSubstr("set xlabel 't (d)'"),
                             testing::HasSubstr("feil i X ved 120 min'"),
                             testing::HasSubstr("feil i X ved 20 d'")));
}

constexpr double width = 357, height = 330;  // of the panel of orders in pixels

/// The panel of orders: its scale, and the labels of the slopes.
struct OrderPanel {
  explicit OrderPanel(const Plot& plot) {
    const auto ranges = matches(plot.script, "set xrange \\[([^:]+):([^\\]]+)\\]");
    low = std::stod(ranges.at(0)[1]);
    high = std::stod(ranges.at(0)[2]);
    const auto found = matches(plot.script, "set label '(h[^']*)' at ([^,]+), ([^ ]+) center");
    for (const std::smatch& label : found) {
      labels.emplace_back(label[1], pixel(std::stod(label[2]), std::stod(label[3])));
    }
  }
  std::pair<double, double> pixel(double step, double error) const {
    return {width * std::log(step / low) / std::log(high / low),
            height * std::log(error / 1e-15) / std::log(1e16)};
  }

  double low, high;
  std::vector<std::pair<std::string, std::pair<double, double>>> labels;
};

TEST(StudyPlot, PutsTheLabelsOfSlopesWhereThereAreNoMarkers) {
  const study::Study study = study_of_all();
  const OrderPanel panel(study_plot(study));
  ASSERT_EQ(panel.labels.size(), 3U);
  for (const auto& [label, place] : panel.labels) {
    const auto& [x, y] = place;
    EXPECT_TRUE(x > 10 && x < width - 10 && y > 10 && y < height - 10) << label;
    for (const study::MethodStudy& m : study.methods) {
      for (const study::StudyRun& run : m.runs) {
        const auto [u, v] = panel.pixel(run.step, run.early_error);
        EXPECT_GT(std::hypot(u - x, v - y), 11) << label << " at " << m.method->name;
      }
    }
  }
}

// Their lines nearly coincide if all steps are nearly alike.
TEST(StudyPlot, PutsTheLabelsOfSlopesApart) {
  study::Study study = study_of_all();
  for (study::MethodStudy& m : study.methods) {
    m.runs.resize(2);
    m.runs[1].step = 1.1 * m.runs[0].step;
  }
  const OrderPanel panel(study_plot(study));
  ASSERT_EQ(panel.labels.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto& [name, one] = panel.labels[i];
      const auto& [other_name, other] = panel.labels[j];
      EXPECT_GT(std::hypot(one.first - other.first, one.second - other.second), 11)
          << name << " and " << other_name;
    }
  }
}

}  // namespace
}  // namespace twrench::plot

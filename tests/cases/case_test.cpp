#include "cases/case.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <filesystem>
#include <numbers>

namespace twrench::cases {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string whole = R"(title = "A top"
source = "A book"
url = "https://example.org"
note = "None."
duration = 5
[inertia]
moments = [1, 2, 3]
unit = "kg m^2"
[initial]
omega = [90, 0, -180]
unit = "deg/s"
[[published]]
time = 5
quantity = "omega"
unit = "deg/s"
values = ["1.25", "-2e-3", "3"]
deviation = 0.5
)";

/// The text with the first `from` replaced.
std::string with(const std::string& from, const std::string& to) {
  std::string text = whole;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(Cases, AreTheFilesOfTheirFolder) {
  std::vector<std::string> files;
  const auto folder = std::filesystem::path(TWRENCH_TESTS_DIR).parent_path() / "assets/cases";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    files.push_back(entry.path().stem().string());
  }
  std::ranges::sort(files);
  EXPECT_EQ(case_names(), files);
  EXPECT_GE(files.size(), 6U);
}

TEST(Cases, SayWhatAReaderNeeds) {
  for (const std::string& name : case_names()) {
    const Case problem = load_case(name, "case");
    EXPECT_EQ(problem.name, name);
    EXPECT_FALSE(problem.title.empty()) << name;
    EXPECT_FALSE(problem.source.empty()) << name;
    EXPECT_FALSE(problem.note.empty()) << name;
    EXPECT_EQ(problem.title.find('\n'), std::string::npos) << name;
    EXPECT_TRUE(problem.url.starts_with("https://")) << name;
  }
}

TEST(Cases, AreReadWithTheirUnits) {
  const Case problem = parse_case(whole, "folder/top.toml");
  EXPECT_EQ(problem.name, "top");
  EXPECT_EQ(problem.moments, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(problem.published_omega, Eigen::Vector3d(90, 0, -180));
  EXPECT_DOUBLE_EQ(problem.omega[0], std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(problem.omega[2], -std::numbers::pi);
  EXPECT_FALSE(problem.attitude);
  EXPECT_EQ(momentum_unit(problem), "kg m^2/s");
  EXPECT_EQ(energy_unit(problem), "kg m^2/s^2");
  ASSERT_EQ(problem.published.size(), 1U);
  EXPECT_EQ(problem.published[0].quantity, Quantity::omega);
  EXPECT_THAT(problem.published[0].digits, ElementsAre("1.25", "-2e-3", "3"));
  EXPECT_THAT(problem.published[0].values, ElementsAre(1.25, -2e-3, 3.0));
  EXPECT_EQ(problem.published[0].deviation, 0.5);
  EXPECT_EQ(momentum_unit(parse_case(with("\"kg m^2\"", "\"\""), "a.toml")), "1/s");
}

TEST(Cases, KnowTheLastDigitOfANumber) {
  EXPECT_DOUBLE_EQ(last_digit("3"), 1);
  EXPECT_DOUBLE_EQ(last_digit("-0.125"), 1e-3);
  EXPECT_DOUBLE_EQ(last_digit("2.5e-07"), 1e-8);
  EXPECT_DOUBLE_EQ(last_digit("2.50E+3"), 10);
  EXPECT_DOUBLE_EQ(last_digit("1e5"), 1e5);
}

TEST(Cases, OfNoSuchNameSuggestTheNearest) {
  try {
    load_case("gazebo-bx", "--case");
    ADD_FAILURE() << "nothing was thrown";
  } catch (const InvalidArgument& error) {
    EXPECT_STREQ(error.what(), "--case: unknown name 'gazebo-bx'");
    EXPECT_THAT(error.remedy(), HasSubstr("did you mean 'gazebo-box'?"));
  }
}

struct Mistake {
  std::string from, to, message;
};

class CaseFile : public testing::TestWithParam<Mistake> {};

TEST_P(CaseFile, IsRefusedWithPlaceAndReason) {
  try {
    parse_case(with(GetParam().from, GetParam().to), "top.toml");
    ADD_FAILURE() << "nothing was thrown";
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(), HasSubstr(GetParam().message));
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, CaseFile,
    testing::Values(
        Mistake{"title = \"A top\"", "title =", "top.toml:1: "},
        Mistake{"source = \"A book\"", "", "source: is missing"},
        Mistake{"note", "noet", "note: is missing"},
        Mistake{"deviation", "deviance", "unknown name 'deviance'"},
        Mistake{"[1, 2, 3]", "[0, 2, 3]", "moments"},
        Mistake{"[inertia]\nmoments = [1, 2, 3]\nunit = \"kg m^2\"\n", "", "inertia: is missing"},
        Mistake{"unit = \"deg/s\"", "unit = \"rpm\"", "initial.unit: is 'rpm'"},
        Mistake{"[[published]]", "attitude = { w = 1, x = 1, y = 0, z = 0 }\n[[published]]",
                "initial.attitude: is not of unit length"},
        Mistake{"time = 5", "time = 6", "published[0].time"},
        Mistake{"quantity = \"omega\"", "quantity = \"omgea\"", "unknown name 'omgea'"},
        Mistake{", \"3\"]", "]", "values: must be 3 strings"},
        Mistake{"\"3\"]", "\"3x\"]", "values: '3x' is not a number"}));

}  // namespace
}  // namespace twrench::cases

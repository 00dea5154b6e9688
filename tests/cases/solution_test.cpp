// Compares the exact values of the cases with an independent series of 40 digits, and the published
// values with both.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/enumeration.h"
#include "cases/case.h"
#include "motion/reference.h"

namespace twrench::cases {
namespace {

using nlohmann::json;

/// The results of tests/reference/cases.py.
const json& reference() {
  static const json document =
      json::parse(std::ifstream(TWRENCH_TESTS_DIR "/reference/cases.json"));
  return document;
}

/// The samples of a case; null if there are none.
json samples_of(const std::string& name) {
  for (const json& entry : reference()) {
    if (entry["name"] == name) return entry["samples"];
  }
  return nullptr;
}

Eigen::Quaterniond quaternion_of(const json& q) {
  using motion::digits;
  return {digits(q[0]), digits(q[1]), digits(q[2]), digits(q[3])};
}

/// The state in a sample of the reference.
State reference_state(const json& sample) {
  Eigen::Quaterniond q = quaternion_of(sample["quaternion"]);
  if (q.w() < 0) q.coeffs() *= -1;
  return {motion::digits(sample["t"]), motion::vector_of(sample["omega"]), q,
          motion::digits(sample["energy"]), motion::vector_of(sample["momentum"])};
}

/// The largest factor by which a change of the initial rates has grown by time t.
double growth(const Case& problem, double t) {
  const double change = 1e-7 * problem.omega.norm();
  double most = 1;
  for (int i = 0; i < 3; ++i) {
    Case other = problem;
    other.omega[i] += change;
    const Eigen::Vector3d difference = Solution(other).at(t).omega - Solution(problem).at(t).omega;
    most = std::max(most, difference.norm() / change);
  }
  return most;
}

class EachCase : public testing::TestWithParam<std::string> {};

TEST_P(EachCase, HasTheExactMotionOfTheReference) {
  const Case problem = load_case(GetParam(), "case");
  const json samples = samples_of(GetParam());
  ASSERT_FALSE(samples.is_null()) << "assets/cases/" << GetParam()
                                  << ".toml is not in tests/reference/cases.json: run "
                                     "tests/reference/cases.py";
  const std::vector<double> times = times_of(problem);
  ASSERT_EQ(samples.size(), times.size()) << "run tests/reference/cases.py";
  const Solution solution(problem);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const State expected = reference_state(samples[i]), state = solution.at(times[i]);
    // Near the separatrix the motion amplifies the round-off of its constants.
    const double tolerance =
        std::max(1e-14, std::numeric_limits<double>::epsilon() * growth(problem, state.t));
    EXPECT_DOUBLE_EQ(state.t, expected.t);
    EXPECT_LT((state.omega - expected.omega).lpNorm<Eigen::Infinity>(),
              tolerance * std::max(1.0, expected.omega.norm()))
        << state.t;
    EXPECT_LT((state.quaternion.coeffs() - expected.quaternion.coeffs()).lpNorm<Eigen::Infinity>(),
              tolerance)
        << state.t;
    EXPECT_NEAR(state.energy, expected.energy, 1e-14 * expected.energy);
    EXPECT_LT((state.momentum - expected.momentum).norm(), 1e-14 * expected.momentum.norm());
  }
}

/// The state at the time of a published value, from the reference rather than from the program.
State state_at(const json& samples, double t) {
  for (const json& sample : samples) {
    if (motion::digits(sample["t"]) == t) return reference_state(sample);
  }
  ADD_FAILURE() << "the reference has no state at " << t << ": run tests/reference/cases.py";
  return {};
}

// If a published value is wrong, the case states the largest difference, to three digits.
TEST_P(EachCase, IsPublishedToItsDigitsOrWithTheDocumentedDeviation) {
  const Case problem = load_case(GetParam(), "case");
  const json samples = samples_of(GetParam());
  ASSERT_FALSE(samples.is_null()) << "run tests/reference/cases.py";
  for (const Published& published : problem.published) {
    const State exact = state_at(samples, published.time);
    if (published.deviation == 0) {
      EXPECT_TRUE(is_right_to_its_digits(published, exact))
          << enumerator_name(published.quantity) << " is off by "
          << largest_difference(published, exact);
    } else {
      EXPECT_FALSE(is_right_to_its_digits(published, exact));
      EXPECT_NEAR(largest_difference(published, exact), published.deviation,
                  0.01 * published.deviation);
    }
  }
}

TEST_P(EachCase, IsWrittenAsJson) {
  const json document = case_json(load_case(GetParam(), "case"));
  EXPECT_EQ(document["name"], GetParam());
  const json samples = samples_of(GetParam());
  ASSERT_EQ(document["exact"].size(), samples.size());
  EXPECT_NEAR(document["exact"].back()["omega"][1].get<double>(),
              motion::digits(samples.back()["omega"][1]), 1e-13);
  for (const json& published : document["published"]) {
    for (std::size_t i = 0; i < published["values"].size(); ++i) {
      EXPECT_EQ(published["difference"][i].get<double>(),
                published["values"][i].get<double>() - published["exact"][i].get<double>());
    }
  }
}

/// The name of a case as a name of a test.
std::string test_name(const testing::TestParamInfo<std::string>& parameter) {
  std::string name = parameter.param;
  std::ranges::replace(name, '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, EachCase, testing::ValuesIn(case_names()), test_name);

TEST(Reference, HasNoCaseThatIsGone) {
  for (const json& entry : reference()) {
    EXPECT_THAT(case_names(), testing::Contains(entry["name"].get<std::string>()));
  }
}

// The notes on the two cases that contradict the exact motion.
TEST(PublishedCases, SayWhatIsWrong) {
  const Case kynema = load_case("kynema-precession", "case");
  const State exact = Solution(kynema).at(5);
  EXPECT_NEAR(exact_components(kynema.published.at(0), exact)[2], -0.303124239, 1e-9);
  EXPECT_NEAR(kynema.published.at(0).values[2], -0.301576820, 1e-9);
  const Case newton = load_case("newton-dzhanibekov", "case");
  const motion::FreeBody body(newton.moments.asDiagonal(), newton.omega);
  EXPECT_EQ(motion::ExactMotion(body).kind(), motion::ExactMotion::Kind::steady);
  EXPECT_EQ(motion::ExactMotion(body).flips(), std::nullopt);
  EXPECT_LT(newton.moments[0], newton.moments[1]);
  EXPECT_LT(newton.moments[1], newton.moments[2]);
}

TEST(Solution, StartsWithThePublishedAttitude) {
  Case problem = load_case("basilisk-spacecraft", "case");
  const State plain = Solution(problem).at(3);
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 2) / 3));
  problem.attitude = turn;
  const State turned = Solution(problem).at(3);
  EXPECT_LT(turned.quaternion.angularDistance(turn * plain.quaternion), 1e-14);
  EXPECT_LT((turned.momentum - turn * plain.momentum).norm(), 1e-12);
  EXPECT_EQ(turned.omega, plain.omega);
}

}  // namespace
}  // namespace twrench::cases

// CPU time to reach an attitude error, for our integrators and those of other libraries.
#include <fmt/format.h>
#include <twrench/motion/exact.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>

#include "motion/reference.h"
#include "problem.h"
#include "timing.h"

namespace twrench::bench {
namespace {

constexpr std::array levels{1e-6, 1e-9, 1e-12};
constexpr std::size_t level_count = levels.size();
constexpr double infinite = std::numeric_limits<double>::infinity();

/// The results of a candidate on a problem.
struct Score {
  const Candidate* candidate;
  double least_error = infinite;
  std::array<std::optional<double>, level_count>
      parameter{};  ///< the cheapest that reaches a level
  std::array<double, level_count> seconds{infinite, infinite, infinite};
};

/// Tries every parameter; those more expensive than 20 ms per run are skipped.
Score search(const Candidate& candidate, const Problem& problem) {
  constexpr double too_long = 0.02;
  Score score{.candidate = &candidate};
  std::array<double, level_count> least;
  least.fill(infinite);
  for (const double parameter : candidate.parameters) {
    Eigen::Matrix3d X = Eigen::Matrix3d::Zero();
    const double seconds = seconds_at_best([&] { X = candidate.run(problem, parameter); });
    const double error = (X - problem.X_end).norm();
    if (std::isfinite(error)) score.least_error = std::min(score.least_error, error);
    for (std::size_t i = 0; i < level_count; ++i) {
      if (error <= levels[i] && seconds < least[i]) {
        least[i] = seconds;
        score.parameter[i] = parameter;
      }
    }
    if (seconds > too_long) break;
  }
  return score;
}

/// Runs rounds over all candidates, so that a slow phase of the machine affects all of them, and
/// keeps the minimum time of each.
void measure(std::vector<Score>& scores, const Problem& problem, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    for (Score& score : scores) {
      for (std::size_t i = 0; i < level_count; ++i) {
        if (!score.parameter[i]) continue;
        const double seconds =
            seconds_each([&] { score.candidate->run(problem, *score.parameter[i]); });
        score.seconds[i] = std::min(score.seconds[i], seconds);
      }
    }
  }
}

void print(const Problem& problem, const std::vector<Score>& scores) {
  std::array<double, level_count> best;
  best.fill(infinite);
  for (const Score& score : scores) {
    if (score.candidate->library != "twrench") continue;
    for (std::size_t i = 0; i < level_count; ++i) best[i] = std::min(best[i], score.seconds[i]);
  }
  fmt::print(
      "\n{}, t = {} s: for each attitude error CPU microseconds, the ratio to our best, and "
      "the tolerance (or number of steps)\n",
      problem.name, problem.t_end);
  fmt::print("{:<41}{:>11.0e}{:>27.0e}{:>27.0e}{:>18}\n", "", levels[0], levels[1], levels[2],
             "reached");
  for (const Score& score : scores) {
    fmt::print("{:<9}{:<32}", score.candidate->library, score.candidate->method);
    for (std::size_t i = 0; i < level_count; ++i) {
      if (score.parameter[i]) {
        fmt::print("{:>9.1f}{:>8.2f}{:>10.2g}", 1e6 * score.seconds[i], score.seconds[i] / best[i],
                   *score.parameter[i]);
      } else {
        fmt::print("{:>9}{:>18}", "-", "");
      }
    }
    fmt::print("{:>9.1e}\n", score.least_error);
  }
}

/// The exact result is the 25-digit reference if it has that time, otherwise the closed form.
Problem problem(const std::string& name, double t_end) {
  const motion::ReferenceCase reference = motion::reference_case(name);
  const auto end = std::ranges::find(reference.samples, t_end, &motion::Sample::t);
  const bool known = end != reference.samples.end();
  return {name, reference.body, t_end,
          known ? end->X : motion::ExactMotion(reference.body).at(t_end).X};
}

void compare(const Problem& problem, int rounds) {
  std::vector<Candidate> candidates;
  for (const auto& list :
       {own_candidates(), odeint_candidates(), sundials_candidates(), gsl_candidates()}) {
    candidates.insert(candidates.end(), list.begin(), list.end());
  }
  std::vector<Score> scores;
  scores.reserve(candidates.size());
  for (const Candidate& candidate : candidates) scores.push_back(search(candidate, problem));
  measure(scores, problem, rounds);
  print(problem, scores);
  static_cast<void>(std::fflush(stdout));  // the next step takes a while
  compare_samples(problem, rounds);
}

}  // namespace

std::vector<double> tolerances() {
  std::vector<double> list;
  for (int i = 8; i <= 64; ++i) list.push_back(std::pow(10.0, -0.25 * i));
  return list;
}

std::vector<double> step_counts() {
  std::vector<double> list;
  for (int i = 20; i <= 80; ++i) list.push_back(std::round(std::exp2(0.25 * i)));
  return list;
}

}  // namespace twrench::bench

int main(int count, char** arguments) {
  using namespace twrench::bench;
  const int rounds = count > 1 ? std::stoi(arguments[1]) : 15;
  compare(problem("wrench-a", 100), rounds);
  compare(problem("near-separatrix", 60), rounds);
  compare(problem("near-separatrix", 100), rounds);
}

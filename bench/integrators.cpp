// CPU time to reach an attitude error, of our integrators and of other libraries' side by side.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <optional>

#include "motion/exact.h"
#include "motion/reference.h"
#include "problem.h"

namespace twrench::bench {
namespace {

constexpr double levels[] = {1e-6, 1e-9, 1e-12};
constexpr std::size_t level_count = std::size(levels);

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// CPU seconds of one call, from as many as fill two milliseconds.
template <class Work>
double seconds_each(Work&& work) {
  constexpr double enough = 2e-3;
  const double start = cpu_seconds();
  double spent = 0;
  int calls = 0;
  while (spent < enough) {
    work();
    ++calls;
    spent = cpu_seconds() - start;
  }
  return spent / calls;
}

/// How a candidate fares on a problem.
struct Score {
  const Candidate* candidate;
  double least_error = std::numeric_limits<double>::infinity();
  std::array<std::optional<double>, level_count>
      parameter{};  ///< the cheapest that reaches a level
  std::array<double, level_count> seconds{};
};

/// Tries every parameter; past 0.1 s for one run, dearer ones are not worth having.
Score search(const Candidate& candidate, const Problem& problem) {
  constexpr double too_long = 0.1;
  Score score{.candidate = &candidate};
  score.seconds.fill(std::numeric_limits<double>::infinity());
  for (const double parameter : candidate.parameters) {
    const double start = cpu_seconds();
    const double error = (candidate.run(problem, parameter) - problem.X_end).norm();
    const double seconds = cpu_seconds() - start;
    if (std::isfinite(error)) score.least_error = std::min(score.least_error, error);
    for (std::size_t i = 0; i < level_count; ++i) {
      if (error <= levels[i] && seconds < score.seconds[i]) {
        score.seconds[i] = seconds;
        score.parameter[i] = parameter;
      }
    }
    if (seconds > too_long) break;
  }
  score.seconds.fill(std::numeric_limits<double>::infinity());
  return score;
}

/// Rounds over all candidates, so that a slow moment of the machine hits all alike; the least time
/// of each counts.
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

/// Seconds for `count` samples of the closed form over the motion, set-up included.
double exact_samples(const Problem& problem, int count, int rounds) {
  double best = std::numeric_limits<double>::infinity(), sum = 0;
  for (int round = 0; round < rounds; ++round) {
    best = std::min(best, seconds_each([&] {
                      const ExactMotion motion(problem.body);
                      for (int i = 1; i <= count; ++i)
                        sum += motion.at(problem.t_end * i / count).X(0, 0);
                    }));
  }
  return std::isnan(sum) ? sum : best;  // so that the samples are used
}

void print(const Problem& problem, const std::vector<Score>& scores, double exact) {
  std::array<double, level_count> best;
  best.fill(std::numeric_limits<double>::infinity());
  for (const Score& score : scores) {
    if (score.candidate->library != "twrench") continue;
    for (std::size_t i = 0; i < level_count; ++i) best[i] = std::min(best[i], score.seconds[i]);
  }
  fmt::print("\n{}, t = {} s: CPU microseconds to an attitude error, and the ratio to our best\n",
             problem.name, problem.t_end);
  fmt::print("{:<10}{:<32}{:>18}{:>18}{:>18}{:>12}\n", "", "", "1e-6", "1e-9", "1e-12", "reached");
  for (const Score& score : scores) {
    fmt::print("{:<10}{:<32}", score.candidate->library, score.candidate->method);
    for (std::size_t i = 0; i < level_count; ++i) {
      if (score.parameter[i]) {
        fmt::print("{:>10.1f}{:>8.2f}", 1e6 * score.seconds[i], score.seconds[i] / best[i]);
      } else {
        fmt::print("{:>10}{:>8}", "-", "");
      }
    }
    fmt::print("{:>12.1e}\n", score.least_error);
  }
  fmt::print("{:<10}{:<32}{:>10.1f}{:>8.2f} of our best at 1e-9\n", "twrench",
             "10,000 samples of the closed form", 1e6 * exact, exact / best[1]);
}

Problem problem(const std::string& name, double t_end) {
  const ReferenceCase reference = reference_case(name);
  const auto end = std::ranges::find(reference.samples, t_end, &Sample::t);
  return {name, reference.body, t_end, end->X};
}

void compare(const Problem& problem, int rounds) {
  std::vector<Candidate> candidates;
  for (const auto& list :
       {own_candidates(), odeint_candidates(), sundials_candidates(), gsl_candidates()}) {
    candidates.insert(candidates.end(), list.begin(), list.end());
  }
  std::vector<Score> scores;
  for (const Candidate& candidate : candidates) scores.push_back(search(candidate, problem));
  measure(scores, problem, rounds);
  print(problem, scores, exact_samples(problem, 10'000, rounds));
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
  const int rounds = count > 1 ? std::atoi(arguments[1]) : 15;
  compare(problem("wrench-a", 100), rounds);
  compare(problem("near-separatrix", 60), rounds);
}

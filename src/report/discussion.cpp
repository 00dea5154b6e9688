#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "report/numbers.h"
#include "report/sections.h"
#include "report/study_tables.h"

namespace twrench::report {
namespace {

Paragraph orders_paragraph(const study::Study& study) {
  std::vector<std::string> orders;
  for (const study::MethodStudy& m : study.methods) {
    if (m.order) orders.push_back(fmt::format("{} {:.2f}", m.method->name, *m.order));
  }
  if (orders.empty()) {
    return {
        "No order can be measured on this motion: the errors are rounding errors or not small "
        "enough."};
  }
  return {
      fmt::format("The measured orders are {}. The theory predicts 1 for the Euler methods; 2 for "
                  "midpoint, trapezoid, implicit-trapezoid and strang, and also for rk4 and "
                  "rkf45 as printed; and 4 for the others with steps. The order of a tableau is "
                  "that in a linear space: on SO(3) it needs the products that averaging "
                  "leaves out. The Taylor series has no measured order, because nothing lies "
                  "between steps that are too long for it and rounding.",
                  fmt::join(orders, ", "))};
}

/// The error and the energy drift of a method in the middle of its ladder; empty if it failed.
std::string error_and_drift(const study::Study& study, std::string_view method) {
  const study::StudyRun* run = middle_run(results_of(study, method));
  if (run == nullptr) return {};
  return fmt::format("{} has an error of X of {} with an energy drift of {} (step {:.4g} s)",
                     method, brief(run->error), brief(run->energy_drift), run->step);
}

Paragraph energy_paragraph(const study::Study& study, Citations& citations) {
  constexpr double round_off = 1e-12;
  const study::StudyRun* plain = middle_run(results_of(study, "lie-euler"));
  if (plain != nullptr && plain->energy_drift < round_off) {
    return {
        fmt::format("The energy says nothing about the methods here: even Lie-Euler, which does "
                    "not conserve it in general, keeps it to {}.",
                    brief(plain->energy_drift))};
  }
  std::vector<std::string> found;
  for (const char* method : {"rk4", "strang", "implicit-trapezoid"}) {
    std::string text = error_and_drift(study, method);
    if (!text.empty()) found.push_back(std::move(text));
  }
  return {fmt::format(
      "The error against the energy: a motion with a large energy drift is wrong, but one without "
      "is "
      "not yet right. {}. The drift decreases with the step as the error does, but the ratio of "
      "the "
      "two differs from method to method: methods that conserve the energy by "
      "construction, or nearly, move along the right curve at a wrong speed {}. The drift is "
      "therefore a check of one method with another step, and not a comparison of methods.",
      fmt::join(found, "; "), citations.cite(hairer))};
}

Paragraph construction_paragraph(const study::Study& study) {
  const study::StudyRun *linear = middle_run(results_of(study, "euler")),
                        *lie = middle_run(results_of(study, "lie-euler"));
  const std::string distances =
      linear == nullptr || lie == nullptr
          ? std::string()
          : fmt::format(
                " Lie-Euler keeps XᵀX = Id to {} although its error of X is {}; Euler's "
                "method is {} away from it.",
                brief(lie->orthogonality_error), brief(lie->error),
                brief(linear->orthogonality_error));
  return {
      "A method on the group keeps XᵀX = Id and the momentum L by construction, up to rounding. "
      "That is no evidence of accuracy." +
      distances};
}

/// The effect of a wrong energy on the flips: rk4 with its longest step.
Paragraph flips_paragraph(const PrintedSolution& solution) {
  const study::Study& rk4 = solution.rk4;
  const study::StudyRun& coarse = rk4.methods.front().runs.front();
  const study::StudyRun& quiet = solution.run();
  if (rk4.flip_times.empty() || !coarse.failure.empty() || !std::isfinite(coarse.flip_error)) {
    return {"Within this time the T-wrench does not turn over."};
  }
  return {fmt::format(
      "The flips are sensitive to the energy: a wrong energy belongs to another motion, with "
      "another "
      "time between flips, and the error of each adds to that of the next. With a step of {} s rk4 "
      "has {} flips of {}, and their times are wrong by up to {} s; with {} s, by {} s. Nothing in "
      "a "
      "film would look wrong.",
      coarse.step, coarse.flips.size(), rk4.flip_times.size(), brief(coarse.flip_error), quiet.step,
      brief(quiet.flip_error))};
}

Paragraph stability_paragraph(std::span<const PrintedSolution> solutions, Citations& citations) {
  std::vector<std::string> swings;
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    if (const auto flips = solutions[i].solution.flips()) {
      swings.push_back(fmt::format("({}) {:.1f}", "abc"[i], flips -> swing * 180 / std::acos(-1)));
    }
  }
  return {fmt::format(
      "The motions agree with the theorem of the intermediate axis {}: a rotation about the axes "
      "of "
      "least and greatest moment is stable, about the intermediate one it is not. The intermediate "
      "axis swings by {} degrees. The momentum L is constant in space and its curve in the body is "
      "the intersection of a sphere with an ellipsoid: small closed curves about the stable axes, "
      "and long ones past both ends of the intermediate axis {}. That is what the graphs show: "
      "waiting near one end, then a quick passage to the other.",
      citations.cite(ashbaugh), fmt::join(swings, ", "), citations.cite(landau))};
}

Paragraph outlook_paragraph() {
  return {
      "Three questions could be examined further. With a torque, or in a body that loses energy, "
      "the methods have no closed form to be compared with. The step control of rkf45 needs an "
      "estimate that sees the whole error. Over very long times, methods that conserve the "
      "energy should win although their errors at a given step are larger."};
}

}  // namespace

Section discussion_of_tasks(std::span<const PrintedSolution> solutions, const study::Study& study,
                            Citations& citations) {
  return {.heading = "Discussion",
          .content = {stability_paragraph(solutions, citations), orders_paragraph(study),
                      energy_paragraph(study, citations), construction_paragraph(study),
                      flips_paragraph(solutions.front()), outlook_paragraph()}};
}

Section discussion_of_motions(const study::Study& study, Citations& citations) {
  return {.heading = "Discussion",
          .content = {orders_paragraph(study), energy_paragraph(study, citations),
                      construction_paragraph(study)}};
}

}  // namespace twrench::report

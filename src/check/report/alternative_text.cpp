#include "check/report/alternative_text.h"

#include <fmt/format.h>

#include "check/report/option_text.h"
#include "recording/conventions/units.h"

namespace twrench::check {
namespace {

using recording::Convention;

/// The moments in the order of a file whose axes are permuted.
std::string moments_text(const Eigen::Matrix3d& inertia, const recording::BodyAxes& axes) {
  const Eigen::Vector3d moments = inertia.diagonal();
  return fmt::format("--inertia {},{},{}", moments[axes.axis[0]], moments[axes.axis[1]],
                     moments[axes.axis[2]]);
}

/// Whether the other axes only reorder the moments. If omega is given, its components would have to
/// be reordered as well.
bool is_moment_order(const Judgement& judgement, const Convention& after) {
  constexpr double rounding = 1e-12;
  const recording::BodyAxes plain;
  return judgement.convention.axes == plain && after.axes.axis != plain.axis &&
         after.axes.matrix().determinant() > 0 && !judgement.is_start_given &&
         judgement.reference.body.inertia().isDiagonal(rounding);
}

/// "t is in ms", "the rates are in deg/s" ...
std::vector<std::string> condition_texts(const Judgement& judgement, const Convention& after) {
  const Convention& before = judgement.convention;
  std::vector<std::string> texts;
  if (time_unit(after) != time_unit(before)) {
    texts.push_back(
        fmt::format("{} is in {}", after.columns.at("t"), name_of(time_unit(after)).option));
  }
  if (rate_unit(after) != rate_unit(before)) {
    texts.push_back(fmt::format("the rates are in {}", name_of(rate_unit(after)).symbol));
  }
  if (angle_unit(after) != angle_unit(before)) {
    texts.push_back(fmt::format("the angles are in {}", name_of(angle_unit(after)).option));
  }
  if (after.columns != before.columns) texts.emplace_back("the columns have another order");
  if (after.sequence != before.sequence) {
    texts.push_back("the sequence of the angles is " + after.sequence);
  }
  if (after.negated != before.negated) {
    texts.push_back(after.columns.at(after.negated) + " has the wrong sign");
  }
  if (after.inverse != before.inverse) {
    texts.push_back(std::string("the attitude is ") +
                    (after.inverse ? "body from space" : "space from body"));
  }
  if (after.rates_in_space != before.rates_in_space) {
    texts.push_back(std::string("the rates are in ") +
                    (after.rates_in_space ? "space axes" : "the body's axes"));
  }
  if (is_moment_order(judgement, after)) {
    texts.emplace_back("the moments have another order");
  } else if (after.axes != before.axes) {
    texts.push_back("its axes are the body's " + format_body_axes(after.axes));
  }
  if (!is_same_offset(before, after)) {
    texts.emplace_back(after.offset ? "the attitude is that of a part that is turned in the body"
                                    : "the attitude is the body's own");
  }
  return texts;
}

}  // namespace

std::string joined(const std::vector<std::string>& parts, std::string_view between) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : std::string(between)) + part;
  return text;
}

std::string alternative_text(const Judgement& judgement, const Convention& after) {
  const Convention& before = judgement.convention;
  Convention options = after;
  std::vector<std::string> parts;
  const bool is_order = is_moment_order(judgement, after);
  if (is_order) {
    options.axes = before.axes;
    parts.push_back(moments_text(judgement.reference.body.inertia(), after.axes));
  }
  const std::string added = option_text(before, options);
  if (!added.empty()) parts.push_back(added);
  std::string use = parts.empty() ? "" : "use " + joined(parts, " ");
  std::vector<std::string> dropped;
  const bool is_dropped = before.inverse && !after.inverse;
  if (is_dropped && !before.inverse_is_stated) dropped.emplace_back("--inverse");
  if (before.offset && !after.offset) dropped.emplace_back("--offset");
  if (!dropped.empty()) {
    const std::string names = joined(dropped, " and ");
    use += use.empty() ? "leave " + names + " out" : ", without " + names;
  }
  if (is_dropped && before.inverse_is_stated) {
    use += (use.empty() ? "" : ", and ") + std::string("correct the direction in the file");
  }
  if (is_order) use += fmt::format(" (or --axes {})", format_body_axes(after.axes));
  if (after.negated != before.negated) {
    use +=
        (use.empty() ? "" : ", and ") + ("reverse the sign of " + after.columns.at(after.negated));
  }
  return joined(condition_texts(judgement, after), " and ") + ": " + use;
}

}  // namespace twrench::check

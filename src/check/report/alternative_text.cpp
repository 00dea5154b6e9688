#include "check/report/alternative_text.h"

#include <fmt/format.h>

#include <string_view>

#include "base/words.h"
#include "recording/conventions/convention.h"

namespace twrench::check {
namespace {

using recording::Convention;

/// The moments in the order of a file whose axes are permuted.
std::string moments_text(const Eigen::Matrix3d& inertia, const recording::BodyAxes& axes) {
  const Eigen::Vector3d moments = inertia.diagonal();
  return argument("inertia", fmt::format("{},{},{}", moments[axes.axis[0]], moments[axes.axis[1]],
                                         moments[axes.axis[2]]));
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
std::vector<std::string> condition_texts(const Judgement& judgement, const Convention& after,
                                         bool is_order) {
  std::vector<std::string> texts;
  for (const recording::Field& field : recording::convention_fields()) {
    if (agree(field, judgement.convention, after)) continue;
    const bool are_axes = field.name == std::string_view("axes");
    texts.push_back(is_order && are_axes ? "the moments have another order"
                                         : field.statement(after));
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
  const std::string added = changing_arguments(before, options);
  if (!added.empty()) parts.push_back(added);
  std::string use = parts.empty() ? "" : "use " + joined(parts, " ");
  std::vector<std::string> dropped;
  const bool is_dropped = before.inverse && !after.inverse;
  if (is_dropped && !before.inverse_is_stated) dropped.push_back(argument("inverse"));
  if (before.offset && !after.offset) dropped.push_back(argument("offset"));
  if (!dropped.empty()) {
    const std::string names = joined(dropped, " and ");
    use += use.empty() ? "leave " + names + " out" : ", without " + names;
  }
  if (is_dropped && before.inverse_is_stated) {
    use += (use.empty() ? "" : ", and ") + std::string("correct the direction in the file");
  }
  if (contradicts_file(before, after))
    use += (use.empty() ? "" : ", and ") + std::string("correct the unit that the file states");
  if (is_order) use += fmt::format(" (or {})", argument("axes", format_body_axes(after.axes)));
  if (after.negated != before.negated) {
    use +=
        (use.empty() ? "" : ", and ") + ("reverse the sign of " + after.columns.at(after.negated));
  }
  return joined(condition_texts(judgement, after, is_order), " and ") + ": " + use;
}

}  // namespace twrench::check

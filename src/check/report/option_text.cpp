#include "check/report/option_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "recording/conventions/units.h"

namespace twrench::check {

using recording::Convention;

std::string option_text(const Convention& before, const Convention& after) {
  std::vector<std::string> options;
  if (after.columns != before.columns) {
    options.push_back("--columns '" + recording::format_columns(after.columns) + "'");
  }
  const bool is_stated = after.time_unit && !before.time_unit;
  if (is_stated || time_unit(after) != time_unit(before)) {
    options.push_back(std::string("--time-unit ") + name_of(time_unit(after)).option);
  }
  if (rate_unit(after) != rate_unit(before)) {
    options.push_back(std::string("--units ") + name_of(rate_unit(after)).option);
  }
  // The unit of angles that follows from --units alone.
  Convention implied = before;
  if (rate_unit(after) != rate_unit(before)) implied.rate_unit = rate_unit(after);
  if (has_angles(attitude_form(after)) && angle_unit(after) != angle_unit(implied)) {
    options.push_back(std::string("--angle-units ") + name_of(angle_unit(after)).option);
  }
  if (after.sequence != before.sequence) options.push_back("--sequence " + after.sequence);
  if (after.inverse && !before.inverse) options.emplace_back("--inverse");
  if (after.rates_in_space != before.rates_in_space) {
    options.push_back(after.rates_in_space ? "--rates space" : "--rates body");
  }
  if (after.axes != before.axes) options.push_back("--axes " + format_body_axes(after.axes));
  if (after.offset && !is_same_offset(before, after)) {
    const Eigen::Quaterniond& q = *after.offset;
    options.push_back(
        fmt::format("--offset {:.15g},{:.15g},{:.15g},{:.15g}", q.w(), q.x(), q.y(), q.z()));
  }
  return fmt::format("{}", fmt::join(options, " "));
}

bool is_same_offset(const Convention& before, const Convention& after) {
  if (!before.offset || !after.offset) return before.offset.has_value() == after.offset.has_value();
  constexpr double rounding = 1e-9;  // rad
  return before.offset->angularDistance(*after.offset) < rounding;
}

}  // namespace twrench::check

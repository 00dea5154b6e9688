#include "check/report/convention_texts.h"

#include <optional>
#include <span>

#include "base/nearest.h"
#include "recording/columns/columns.h"
#include "recording/conventions/body_axes.h"
#include "recording/conventions/units.h"

namespace twrench::check {
namespace {

/// Returns the unit with that name; nothing if the name is empty.
template <typename Name>
auto unit_named(std::span<const Name> units, const std::string& name, const std::string& option) {
  std::optional<decltype(Name::unit)> found;
  std::vector<std::string> names;
  for (const Name& unit : units) {
    if (unit.option == name) found = unit.unit;
    names.emplace_back(unit.option);
  }
  if (!found && !name.empty()) throw unknown_name(option, name, names);
  return found;
}

}  // namespace

recording::Convention parse_convention(const ConventionTexts& texts) {
  recording::Convention given;
  if (!texts.columns.empty()) given.columns = recording::parse_columns(texts.columns, "--columns");
  given.time_unit = unit_named(recording::time_units(), texts.time_unit, "--time-unit");
  given.rate_unit = unit_named(recording::rate_units(), texts.units, "--units");
  given.angle_unit = unit_named(recording::angle_units(), texts.angle_units, "--angle-units");
  if (!texts.sequence.empty())
    given.sequence = recording::parse_sequence(texts.sequence, "--sequence");
  given.inverse = texts.inverse;
  if (texts.rates != "body" && texts.rates != "space") {
    throw unknown_name("--rates", texts.rates, std::vector<std::string>{"body", "space"});
  }
  given.rates_in_space = texts.rates == "space";
  if (!texts.axes.empty()) given.axes = recording::parse_body_axes(texts.axes, "--axes");
  return given;
}

}  // namespace twrench::check

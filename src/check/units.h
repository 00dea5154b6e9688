#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "check/convention.h"

namespace twrench::check {

/// The words of a column's name in small letters: "bodyRate_deg_s[0]" -> body, rate, deg, s, 0.
/// Greek letters are their names; w and omega are parted from the axis behind them: "wx" -> w, x.
std::vector<std::string> words_of(std::string_view name);

/// What the words of a name say of its unit, and the words without it.
struct StatedUnit {
  std::vector<std::string> other_words;
  std::optional<RateUnit> rate;  ///< of an angular rate; of an angle, this unit without the second
  std::optional<TimeUnit> time;
  std::string unread;  ///< a unit of angles that is not read ("gon"), or empty
};

/// Takes the words of units from a name.
StatedUnit stated_unit(const std::vector<std::string>& words);

/// The same for a column, of which the row below the names may tell more.
StatedUnit stated_unit(const table::Header& header, std::size_t column);

/// How options and people name a unit of rates, and how large it is.
struct RateUnitName {
  RateUnit unit;
  const char* option;  ///< "deg"
  const char* symbol;  ///< "deg/s"
  double in_rad_s;     ///< how many rad/s one of it has
};
const std::vector<RateUnitName>& rate_units();
const RateUnitName& name_of(RateUnit unit);

/// The same of angles.
struct AngleName {
  Angle unit;
  const char* option;  ///< "deg"
  double in_rad;
};
const std::vector<AngleName>& angle_units();
const AngleName& name_of(Angle unit);

/// The same of times.
struct TimeUnitName {
  TimeUnit unit;
  const char* option;  ///< "ms"
  double in_s;
};
const std::vector<TimeUnitName>& time_units();
const TimeUnitName& name_of(TimeUnit unit);

/// The unit of angles that a rate has in each second; nothing for revolutions, in which nobody
/// writes Euler angles.
std::optional<Angle> angle_of(RateUnit unit);

}  // namespace twrench::check

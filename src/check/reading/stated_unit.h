#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "check/conventions/convention.h"
#include "table/reader.h"

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

}  // namespace twrench::check

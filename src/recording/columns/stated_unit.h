#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recording/conventions/convention.h"
#include "table/reader.h"

namespace twrench::recording {

/// Splits a column's name into lower-case words: "bodyRate_deg_s[0]" -> body, rate, deg, s, 0.
/// Greek letters become their names; w and omega are separated from an axis that follows:
/// "wx" -> w, x.
std::vector<std::string> words_of(std::string_view name);

/// The unit that the words of a name state, and the other words.
struct StatedUnit {
  std::vector<std::string> other_words;
  std::optional<RateUnit> rate;  ///< of an angular rate; for an angle, deg/s means deg
  std::optional<TimeUnit> time;
  bool ends_with_time = false;  ///< the last word is a unit of times alone: "wx_ms"
  bool is_per_second = false;   ///< the unit of angles is divided by a time: "deg/s", but not "deg"
  std::string unread;           ///< a unit of angles that is not supported ("gon"), or empty
};

/// Separates the words of units from the others.
StatedUnit stated_unit(const std::vector<std::string>& words);

/// Does the same for a column; a unit in the row below the names takes precedence.
/// Calendar times are in seconds.
StatedUnit stated_unit(const table::Header& header, std::size_t column);

/// The unit of rates and angles that a line before the names states: inDegrees=yes or no.
std::optional<RateUnit> unit_in_preamble(const table::Header& header);

}  // namespace twrench::recording

#include "recording/columns/open_conventions.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "base/enumeration.h"
#include "base/words.h"
#include "recording/columns/column_sets.h"
#include "recording/columns/columns.h"
#include "recording/columns/derived_times.h"
#include "recording/columns/stated_unit.h"
#include "recording/conventions/names.h"
#include "recording/conventions/units.h"

namespace twrench::recording {
namespace {

/// The kinds of columns that are an attitude.
std::vector<Kind> attitude_kinds() {
  std::vector<Kind> kinds;
  for (const AttitudeForm form : enumerators<AttitudeForm>) {
    if (const auto kind = kind_of(form)) kinds.push_back(*kind);
  }
  return kinds;
}

/// The columns of the time, the rates and the attitude in one reading of the file; either of the
/// last two may be missing.
struct ColumnChoice {
  ColumnSet time;
  std::optional<ColumnSet> rates, attitude;
};

/// The unit that the name of a column states, or a stated unit that is not supported.
template <typename Unit>
struct Stated {
  std::optional<Unit> unit;
  std::string unread;
};

/// The column with our name, if there is exactly one.
std::optional<std::size_t> column_of_our_name(const table::Header& header,
                                              const std::string& ours) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < header.names.size(); ++i) {
    if (to_lower(header.names[i]) != ours) continue;
    if (found) return std::nullopt;
    found = i;
  }
  return found;
}

/// The set of a kind as the user gave it; nothing if the user named none of its columns. The other
/// columns of the set are looked up by our names.
std::optional<ColumnSet> said_set(const table::Header& header, const Convention& said, Kind kind) {
  ColumnSet set{kind, {}, false};
  std::string missing, found;
  for (const std::string& ours : names_of(kind)) {
    const auto theirs = said.columns.find(ours);
    if (theirs != said.columns.end()) {
      found = ours;
      set.columns.push_back(find_column(header, ours, theirs->second));
    } else if (const auto column = column_of_our_name(header, ours)) {
      set.columns.push_back(*column);
    } else if (missing.empty()) {
      missing = ours;
    }
  }
  if (found.empty()) return std::nullopt;
  if (!missing.empty()) {
    throw ColumnError(header.file, missing,
                      fmt::format("columns are given for {}, but not for {}", found, missing),
                      columns_remedy(header));
  }
  return set;
}

table::BadTable said_twice(const table::Header& header, const ColumnSet& a, const ColumnSet& b) {
  return {header.file,
          fmt::format("columns are given both for {} and for {}", description_of(a.kind),
                      description_of(b.kind)),
          "name those of one of them"};
}

/// The rates, or else the angular momentum, as the user gave them. Throws if both are named.
std::optional<ColumnSet> said_rates(const table::Header& header, const Convention& said) {
  const auto rates = said_set(header, said, Kind::rates);
  const auto momentum = said_set(header, said, Kind::momentum);
  if (rates && momentum) throw said_twice(header, *rates, *momentum);
  return rates ? rates : momentum;
}

/// The attitude as the user gave it. Throws if columns of several forms are named.
std::optional<ColumnSet> said_attitude(const table::Header& header, const Convention& said) {
  std::optional<ColumnSet> attitude;
  for (const Kind kind : attitude_kinds()) {
    const auto set = said_set(header, said, kind);
    if (set && attitude) throw said_twice(header, *attitude, *set);
    if (set) attitude = set;
  }
  return attitude;
}

/// The sets, or one empty element if there are none.
std::vector<std::optional<ColumnSet>> or_nothing(const std::vector<ColumnSet>& sets) {
  if (sets.empty()) return {std::nullopt};
  return {sets.begin(), sets.end()};
}

std::vector<ColumnSet> times(const table::Header& header, const Convention& said) {
  if (const auto set = said_set(header, said, Kind::time)) return {*set};
  std::vector<ColumnSet> found = find_sets(header, Kind::time);
  const auto frames = frame_column(header);
  if (found.empty() && frames) {
    throw unknown_rate(header, fmt::format("'{}'", header.names[*frames]));
  }
  if (found.empty()) {
    throw ColumnError(header.file, "t", "no column is recognised as the time",
                      columns_remedy(header) +
                          "; if none has times, state the rate of the rows in a comment above "
                          "them, such as '# frame rate: 100 Hz'");
  }
  return found;
}

/// The rates by the names of their columns; only without them, the angular momentum, because it has
/// less usual names.
std::vector<ColumnSet> find_rates(const table::Header& header) {
  std::vector<ColumnSet> rates = find_sets(header, Kind::rates);
  return rates.empty() ? find_sets(header, Kind::momentum) : rates;
}

/// The attitudes by the names of their columns. Names that have other usual meanings count only if
/// no others are there, and so do Euler angles whose sequence is open, unless other attitudes have
/// the same columns.
std::vector<ColumnSet> find_attitudes(const table::Header& header, const Convention& said,
                                      Incomplete incomplete) {
  std::vector<ColumnSet> found;
  for (const Kind kind : attitude_kinds())
    std::ranges::move(find_sets(header, kind, incomplete), std::back_inserter(found));
  if (!std::ranges::all_of(found, &ColumnSet::is_weak)) std::erase_if(found, &ColumnSet::is_weak);
  // Three of the four columns of a quaternion may have the names of other rotations.
  const auto quaternion = std::ranges::find(found, Kind::quaternion, &ColumnSet::kind);
  if (quaternion != found.end()) {
    const std::set of_quaternion(quaternion->columns.begin(), quaternion->columns.end());
    std::erase_if(found, [&](const ColumnSet& set) {
      return set.columns.size() < of_quaternion.size() &&
             std::ranges::all_of(
                 set.columns, [&](std::size_t column) { return of_quaternion.contains(column); });
    });
  }
  const auto is_preferred = [&](const ColumnSet& other, const ColumnSet& euler) {
    return other.kind != Kind::euler && std::set(other.columns.begin(), other.columns.end()) !=
                                            std::set(euler.columns.begin(), euler.columns.end());
  };
  const std::vector<ColumnSet> all = found;
  std::erase_if(found, [&](const ColumnSet& set) {
    const bool has_open_sequence =
        set.kind == Kind::euler && header.sequence.empty() && said.sequence.empty();
    return has_open_sequence && std::ranges::any_of(all, [&](const ColumnSet& other) {
             return is_preferred(other, set);
           });
  });
  return found;
}

/// Whether the names only count the columns; MATLAB writes Var1, Var2 ... for a matrix.
bool is_without_names(const table::Header& header) {
  const auto count = [&](std::string_view before) {
    for (std::size_t i = 0; i < header.names.size(); ++i) {
      if (header.names[i] != fmt::format("{}{}", before, i + 1)) return false;
    }
    return true;
  };
  return count("#") || count("Var");
}

/// The columns of a kind from `first` on, in each order that they may have.
std::vector<ColumnSet> sets_from(std::size_t first, Kind kind) {
  std::vector<std::size_t> columns(names_of(kind).size());
  std::iota(columns.begin(), columns.end(), first);
  return orders_of(kind, columns);
}

/// The possible columns of a file without names, judging by their number: a time followed by rates,
/// an attitude or both in either order, or by a position and an attitude. Empty for other numbers
/// of columns.
std::vector<ColumnChoice> choices_by_number(const table::Header& header) {
  const std::size_t count = header.names.size();
  const ColumnSet time = sets_from(0, Kind::time).front();
  const auto rates_from = [](std::size_t first) { return sets_from(first, Kind::rates).front(); };
  std::vector<ColumnChoice> all;
  if (count == 4) all.push_back({time, rates_from(1), {}});
  for (const Kind kind : {Kind::quaternion, Kind::matrix}) {
    const std::size_t numbers = names_of(kind).size();
    if (count == 1 + numbers) {
      for (const ColumnSet& set : sets_from(1, kind)) all.push_back({time, {}, set});
    }
    if (count != 4 + numbers) continue;
    for (const ColumnSet& set : sets_from(1, kind))
      all.push_back({time, rates_from(1 + numbers), set});
    for (const ColumnSet& set : sets_from(4, kind)) all.push_back({time, rates_from(1), set});
    // Three columns before the attitude may also be a position, which is not read.
    for (const ColumnSet& set : sets_from(4, kind)) all.push_back({time, {}, set});
  }
  return all;
}

/// The rates in a file that says by its own name rather than by those of its columns that it has
/// rates: gyroscope.csv. Throws ColumnError if it does not: x, y, z may as well be a position.
std::vector<ColumnSet> bare_rates(const table::Header& header) {
  std::vector<ColumnSet> sets = find_bare_rates(header);
  const std::vector<std::string> words = words_of(header.file.substr(header.file.rfind('/') + 1));
  const bool is_named = std::ranges::any_of(words, [](const std::string& word) {
    return word == "gyro" || word == "gyroscope" || word == "gyr" || word == "angular" ||
           word == "omega" || word == "rate" || word == "rates" || word == "rotation";
  });
  if (sets.empty() || is_named) return sets;
  std::map<std::string, std::string> columns;
  std::string names;
  for (std::size_t i = 0; i < 3; ++i) {
    columns[names_of(Kind::rates)[i]] = name_for(header, sets.front().columns[i]);
    names += (i == 0 ? "'" : ", '") + header.names[sets.front().columns[i]] + "'";
  }
  throw ColumnError(
      header.file, format_columns(columns),
      "no columns have names of rates or of an attitude, but " + names + " may be rates");
}

std::vector<ColumnChoice> column_choices(const table::Header& header, const Convention& said) {
  if (said.columns.empty() && is_without_names(header)) {
    if (auto choices = choices_by_number(header); !choices.empty()) return choices;
  }
  std::vector<std::optional<ColumnSet>> rates{said_rates(header, said)};
  std::vector<std::optional<ColumnSet>> attitude{said_attitude(header, said)};
  if (!rates.front() && !attitude.front()) {
    std::vector<ColumnSet> found_rates = find_rates(header);
    std::vector<ColumnSet> found = find_attitudes(
        header, said, found_rates.empty() ? Incomplete::refused : Incomplete::ignored);
    if (found_rates.empty() && found.empty()) found = find_bare_quaternions(header);
    if (found_rates.empty() && found.empty()) found_rates = bare_rates(header);
    rates = or_nothing(found_rates);
    attitude = or_nothing(found);
  }
  if (!rates.front() && !attitude.front()) {
    throw ColumnError(header.file, "", "no columns have names of rates or of an attitude",
                      columns_remedy(header));
  }
  std::vector<ColumnChoice> all;
  for (const ColumnSet& t : times(header, said)) {
    for (const auto& r : rates) {
      for (const auto& a : attitude) all.push_back({t, r, a});
    }
  }
  constexpr std::size_t most = 64;
  if (all.size() <= most) return all;
  throw ColumnError(header.file, "", "its columns can be read in too many ways",
                    "say which ones are meant");
}

void add_columns(const table::Header& header, const ColumnSet& set, Convention& convention) {
  for (std::size_t i = 0; i < set.columns.size(); ++i) {
    const std::string& ours = names_of(set.kind)[i];
    const std::string theirs = name_for(header, set.columns[i]);
    if (set.kind != Kind::time && header.calendar_of(set.columns[i]) != table::Calendar::none) {
      throw ColumnError(header.file, ours,
                        fmt::format("the column '{}' has calendar times, not {}", theirs, ours),
                        columns_remedy(header));
    }
    for (const auto& [other, column] : convention.columns) {
      if (column != theirs) continue;
      throw ColumnError(
          header.file, ours,
          fmt::format("the column '{}' is used for both {} and {}", theirs, other, ours),
          "give each a separate column");
    }
    convention.columns[ours] = theirs;
  }
}

/// The unit that the columns of the set state, or else the one that the user gave. `unit_of`
/// extracts it from the words of a name. A stated unit is noted as that of the field.
template <typename Unit, typename UnitOf>
std::optional<Unit> unit_of_set(const table::Header& header, const ColumnSet& set,
                                std::optional<Unit> said, const UnitOf& unit_of, const char* field,
                                Convention& convention) {
  std::optional<Unit> stated;
  for (const std::size_t column : set.columns) {
    const std::string& name = header.names[column];
    const StatedUnit words = stated_unit(header, column);
    const Stated<Unit> here = unit_of(words);
    if (!here.unread.empty()) {
      throw table::BadTable(
          header.file,
          fmt::format("the column '{}' is in {}, which is not supported", name, here.unread),
          "convert it to radians or degrees, and to seconds");
    }
    if (!here.unit) continue;
    const std::optional<Unit> other = stated ? stated : said;
    if (other && *other != *here.unit) {
      throw table::BadTable(header.file,
                            fmt::format("the column '{}' states {}, but {} {}", name,
                                        name_of(*here.unit).option, name_of(*other).option,
                                        stated ? "is stated by another of its kind" : "is given"),
                            "one of the two is wrong");
    }
    stated = here.unit;
  }
  if (stated) convention.stated_units.insert(field);
  return stated ? stated : said;
}

Stated<TimeUnit> time_in(const StatedUnit& words) {
  if (words.rate) return {{}, name_of(*words.rate).option};
  return {words.time, words.unread};
}

/// Whether the name states a unit of times; a column may just be called "s".
bool is_in_time_unit(const StatedUnit& words) {
  return !words.other_words.empty() && words.unread.empty() && !words.rate && words.ends_with_time;
}

Stated<RateUnit> rate_in(const StatedUnit& words) {
  if (is_in_time_unit(words)) return {{}, name_of(*words.time).option};
  return {words.rate, words.unread};
}

Stated<Angle> angle_in(const StatedUnit& words) {
  if (is_in_time_unit(words)) return {{}, name_of(*words.time).option};
  if (!words.rate) return {{}, words.unread};
  const auto angle = angle_of(*words.rate);
  return {angle, angle ? words.unread : name_of(*words.rate).option};
}

/// The unit of rates that the lines before the names state, or else the one that the user gave.
std::optional<RateUnit> rate_unit_of_file(const table::Header& header,
                                          std::optional<RateUnit> said) {
  const std::optional<RateUnit> stated = unit_in_preamble(header);
  if (!stated || !said || *stated == *said) return stated ? stated : said;
  throw table::BadTable(header.file,
                        fmt::format("the lines before its names state {}, but {} is given",
                                    name_of(*stated).option, name_of(*said).option),
                        "one of the two is wrong");
}

Convention convention_of(const table::Header& header, const ColumnChoice& choice,
                         const Convention& said) {
  Convention convention = said;
  convention.columns.clear();
  add_columns(header, choice.time, convention);
  convention.time_unit =
      unit_of_set(header, choice.time, said.time_unit, time_in, "time_unit", convention);
  const std::optional<RateUnit> rate_unit = rate_unit_of_file(header, said.rate_unit);
  if (unit_in_preamble(header)) convention.stated_units.insert({"units", "angle_units"});
  if (choice.rates) {
    add_columns(header, *choice.rates, convention);
    if (choice.rates->kind == Kind::rates) {
      convention.rate_unit =
          unit_of_set(header, *choice.rates, rate_unit, rate_in, "units", convention);
    }
    convention.rates_in_space = said.rates_in_space || choice.rates->in_space;
  }
  if (!choice.attitude) return convention;
  add_columns(header, *choice.attitude, convention);
  convention.inverse = said.inverse || header.states_inverse.value_or(false);
  convention.inverse_is_stated = header.states_inverse.has_value() && !said.inverse;
  if (convention.sequence.empty()) convention.sequence = header.sequence;
  if (has_angles(attitude_form(convention))) {
    std::optional<Angle> said_angle = said.angle_unit;
    if (!said_angle && rate_unit) said_angle = angle_of(*rate_unit);
    convention.angle_unit =
        unit_of_set(header, *choice.attitude, said_angle, angle_in, "angle_units", convention);
  }
  return convention;
}

/// Adds the convention, once for each sequence if it leaves the sequence open.
void add_with_sequences(Convention convention, std::vector<Convention>& all) {
  if (attitude_form(convention) != AttitudeForm::euler || !convention.sequence.empty()) {
    all.push_back(std::move(convention));
    return;
  }
  for (const char* sequence : {"zyx", "zxy", "yxz", "yzx", "xyz", "xzy"}) {
    convention.sequence = sequence;
    all.push_back(convention);
  }
}

}  // namespace

std::vector<Convention> conventions(const table::Header& header, const Convention& said) {
  std::vector<Convention> all;
  for (const ColumnChoice& choice : column_choices(header, said)) {
    add_with_sequences(convention_of(header, choice, said), all);
  }
  return all;
}

}  // namespace twrench::recording

#include "recording/columns/derived_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "recording/columns/stated_rate.h"
#include "recording/columns/stated_unit.h"
#include "recording/columns/word_lists.h"
#include "table/calendar.h"
#include "table/error.h"

namespace twrench::recording {
namespace {

using table::Calendar;
using table::Number;

constexpr long long nanoseconds_in_second = 1'000'000'000;

/// How a time follows from other columns.
enum class Rule {
  seconds_and_fraction,
  date_and_clock,
  week_and_seconds,
  year_to_second,
  frames,
  rows
};

/// A time that follows from other columns.
struct Derived {
  Rule rule;
  std::vector<std::size_t> from;
  double unit = 1;   ///< of the last column, s
  int decimals = 9;  ///< of a fraction
};

/// A column of numbers that begin again at 0 after `size - 1`.
struct Counter {
  std::size_t column;
  double size;
  double last = 0, added = 0;
};

/// A word for the fractions of a second, and how many decimals it has.
struct Fraction {
  std::string_view word;
  int decimals;
};
constexpr std::array<Fraction, 7> fractions{{{"nanosec", 9},
                                             {"nanosecs", 9},
                                             {"nsec", 9},
                                             {"nsecs", 9},
                                             {"usec", 6},
                                             {"usecs", 6},
                                             {"microsec", 6}}};

/// The columns "sec" and "nanosec" that have the same words before.
void add_sums_of_seconds(const table::Header& header, std::vector<Derived>& all) {
  for (std::size_t second = 1; second < header.names.size(); ++second) {
    Words words = words_of(header.names[second]);
    if (words.empty()) continue;
    const auto* const fraction = std::ranges::find(fractions, words.back(), &Fraction::word);
    if (fraction == fractions.end()) continue;
    for (const char* seconds : {"sec", "secs", "seconds"}) {
      words.back() = seconds;
      if (words_of(header.names[second - 1]) != words) continue;
      all.push_back({Rule::seconds_and_fraction,
                     {second - 1, second},
                     std::pow(10.0, -fraction->decimals),
                     fraction->decimals});
    }
  }
}

/// A column of dates before one with the times of the day.
void add_dates(const table::Header& header, std::vector<Derived>& all) {
  for (std::size_t second = 1; second < header.names.size(); ++second) {
    const bool is_pair = header.calendar_of(second - 1) == Calendar::date &&
                         header.calendar_of(second) == Calendar::time_of_day;
    if (is_pair) all.push_back({Rule::date_and_clock, {second - 1, second}});
  }
}

/// The weeks of GPS beside the seconds of the week.
void add_weeks(const table::Header& header, std::vector<Derived>& all) {
  const auto is_week = [&](std::size_t column) {
    const Words words = words_of(header.names[column]);
    return has_any(words, {"week", "wk"}) &&
           has_only(words, {"gps", "week", "wk", "number", "no", "wn"});
  };
  for (std::size_t column = 0; column < header.names.size(); ++column) {
    const StatedUnit unit = stated_unit(words_of(header.names[column]));
    const Words& words = unit.other_words;
    const bool is_time = has_any(words, {"tow", "sow"}) || unit.time ||
                         (has_any(words, {"time"}) && has_any(words, {"week"}));
    const bool is_known = has_only(words, {"gps", "i", "tow", "sow", "time", "of", "week"});
    if (!is_time || !is_known || is_week(column)) continue;
    const double size = unit.time == TimeUnit::ms || has_any(words, {"i"}) ? 1e-3 : 1;
    if (column > 0 && is_week(column - 1)) {
      all.push_back({Rule::week_and_seconds, {column - 1, column}, size});
    } else if (column + 1 < header.names.size() && is_week(column + 1)) {
      all.push_back({Rule::week_and_seconds, {column + 1, column}, size});
    }
  }
}

/// Six neighbouring columns from the year to the second.
void add_years(const table::Header& header, std::vector<Derived>& all) {
  const std::vector<std::vector<std::string_view>> words{{"year"},
                                                         {"month"},
                                                         {"day"},
                                                         {"hour", "hours"},
                                                         {"minute", "minutes", "min"},
                                                         {"second", "seconds", "sec"}};
  for (std::size_t first = 0; first + words.size() <= header.names.size(); ++first) {
    std::vector<std::size_t> columns;
    for (std::size_t i = 0; i < words.size(); ++i) {
      const Words name = words_of(header.names[first + i]);
      const bool is_there =
          !name.empty() && std::ranges::find(words[i], name.back()) != words[i].end();
      if (is_there) columns.push_back(first + i);
    }
    if (columns.size() == words.size()) all.push_back({Rule::year_to_second, columns});
  }
}

/// Whether the name of a column may be that of a time, even if it is not recognised as one.
bool has_times(const table::Header& header) {
  return std::ranges::any_of(header.names, [](const std::string& name) {
    const Words words = words_of(name);
    return has_any(words, {"t", "time", "timestamp", "stamp", "date", "clock", "elapsed", "epoch",
                           "zeit"}) ||
           stated_unit(words).ends_with_time;
  });
}

std::vector<Derived> derived_times(const table::Header& header) {
  std::vector<Derived> all;
  add_sums_of_seconds(header, all);
  add_dates(header, all);
  add_weeks(header, all);
  add_years(header, all);
  const auto rate = stated_rate(header);
  const auto frames = frame_column(header);
  if (rate && frames) all.push_back({Rule::frames, {*frames}, 1 / *rate});
  if (rate && !frames && !has_times(header)) all.push_back({Rule::rows, {}, 1 / *rate});
  return all;
}

std::string name_of_derived(const table::Header& header, const Derived& one) {
  if (one.rule == Rule::frames || one.rule == Rule::rows) {
    return fmt::format("{} / {:.15g} Hz", one.from.empty() ? "row" : header.names[one.from[0]],
                       1 / one.unit);
  }
  std::string name;
  for (const std::size_t column : one.from)
    name += (name.empty() ? "" : " + ") + header.names[column];
  return name;
}

std::vector<Counter> counters_in(const table::Header& header) {
  std::vector<Counter> counters;
  for (std::size_t column = 0; column < header.names.size(); ++column) {
    const Words words = words_of(header.names[column]);
    if (words == Words{"packet", "counter"}) counters.push_back({column, 65536});
    if (words == Words{"sample", "time", "fine"}) counters.push_back({column, 4294967296});
  }
  return counters;
}

/// Continues the counter where it begins again.
void unwrap(Counter& counter, Number& number) {
  constexpr double most_step_back = 0.5;
  const double value = number.value;
  if (value < counter.last - most_step_back * counter.size) counter.added += counter.size;
  counter.last = value;
  number.value += counter.added;
}

class DerivedTimes : public table::Reader {
 public:
  DerivedTimes(std::unique_ptr<table::Reader> table, std::vector<Derived> derived,
               std::vector<Counter> counters)
      : table_(std::move(table)), derived_(std::move(derived)), counters_(std::move(counters)) {
    header_ = table_->header();
    const std::size_t columns = header_.names.size();
    if (!derived_.empty()) header_.units.resize(columns);
    header_.sources.resize(columns);
    for (const Derived& one : derived_) {
      header_.names.push_back(name_of_derived(header_, one));
      header_.sources.push_back(one.from);
      if (one.from.empty()) header_.sources.back() = {columns};  // it follows from none of the file
      header_.units.emplace_back("s");
      const bool is_calendar = one.rule == Rule::date_and_clock || one.rule == Rule::year_to_second;
      if (!is_calendar) continue;
      header_.calendar.resize(header_.names.size());
      header_.calendar.back() = Calendar::date_time;
    }
  }

  void begin_pass(std::span<const std::size_t> columns) override {
    const std::size_t in_table = table_->header().names.size();
    needed_.clear();
    places_.clear();
    for (const std::size_t column : columns) {
      const Derived* const derived = column < in_table ? nullptr : &derived_[column - in_table];
      places_.push_back({needed_.size(), derived});
      if (derived) {
        needed_.insert(needed_.end(), derived->from.begin(), derived->from.end());
      } else {
        needed_.push_back(column);
      }
    }
    for (Counter& counter : counters_) counter.last = counter.added = 0;
    rows_ = 0;
    numbers_.resize(needed_.size());
    table_->begin_pass(needed_);
  }

  bool next(std::span<Number> numbers) override {
    if (!table_->next(numbers_)) return false;
    ++rows_;
    for (Counter& counter : counters_) continue_counter(counter);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Place& place = places_[i];
      numbers[i] = place.derived ? time_of(*place.derived, std::span(numbers_).subspan(place.at))
                                 : numbers_[place.at];
    }
    return true;
  }

  std::string place() const override { return table_->place(); }

 private:
  /// The place of a selected column among the numbers of the table.
  struct Place {
    std::size_t at;
    const Derived* derived;  ///< null for a column of the table
  };

  /// A column may be selected more than once.
  void continue_counter(Counter& counter) {
    std::optional<Number> number;
    for (std::size_t i = 0; i < needed_.size(); ++i) {
      if (needed_[i] != counter.column) continue;
      if (!number) {
        number = numbers_[i];
        unwrap(counter, *number);
      }
      numbers_[i] = *number;
    }
  }

  Number time_of(const Derived& one, std::span<const Number> numbers) const {
    switch (one.rule) {
      case Rule::seconds_and_fraction: {
        const double most = std::round(1 / one.unit) - 1;
        const long long seconds = whole(one.from[0], numbers[0], -9e9, 9e9);
        const long long parts = whole(one.from[1], numbers[1], 0, most);
        return table::seconds_from(seconds * nanoseconds_in_second +
                                       parts * std::llround(one.unit * nanoseconds_in_second),
                                   one.decimals);
      }
      case Rule::date_and_clock:
        return with_fraction(whole(one.from[0], numbers[0], -9e9, 9e9), numbers[1], 1);
      case Rule::week_and_seconds: {
        constexpr long long in_week = 604800;
        return with_fraction(in_week * whole(one.from[0], numbers[0], 0, 1e4), numbers[1],
                             one.unit);
      }
      case Rule::year_to_second: {
        const std::string minute = fmt::format(
            "{:04}-{:02}-{:02}T{:02}:{:02}", whole(one.from[0], numbers[0], 1900, 2200),
            whole(one.from[1], numbers[1], 1, 12), whole(one.from[2], numbers[2], 1, 31),
            whole(one.from[3], numbers[3], 0, 23), whole(one.from[4], numbers[4], 0, 59));
        Number number;
        if (table::read_calendar(minute, number) != Calendar::date_time) {
          throw bad_part(one.from[2], numbers[2], 1, 31);
        }
        return with_fraction(std::llround(number.value), numbers[5], 1);
      }
      case Rule::frames:
        return {.value = numbers[0].value * one.unit};
      case Rule::rows:
        return {.value = static_cast<double>(rows_ - 1) * one.unit};
    }
    return {};
  }

  /// The sum of seconds and a number of this unit with a fraction.
  static Number with_fraction(long long seconds, const Number& number, double unit) {
    const double size = unit * nanoseconds_in_second;
    const int decimals = number.decimals + (unit == 1 ? 0 : 3);
    return table::seconds_from(
        seconds * nanoseconds_in_second + std::llround(number.value * size + number.rest * size),
        std::clamp(decimals, 0, 9));
  }

  long long whole(std::size_t column, const Number& number, double least, double most) const {
    const bool is_whole = number.value == std::floor(number.value);
    if (is_whole && number.value >= least && number.value <= most)
      return std::llround(number.value);
    throw bad_part(column, number, least, most);
  }

  table::BadTable bad_part(std::size_t column, const Number& number, double least,
                           double most) const {
    return {table::cell_place(place(), header_.names[column]),
            fmt::format("{} is no part of a time in several columns", number.value),
            fmt::format("it must be a whole number from {:.0f} to {:.0f}, or else name the column "
                        "of the time",
                        least, most)};
  }

  std::unique_ptr<table::Reader> table_;
  std::vector<Derived> derived_;
  std::vector<Counter> counters_;
  std::size_t rows_ = 0;       ///< read in this pass
  std::vector<Place> places_;  ///< of the selected columns
  std::vector<std::size_t> needed_;
  std::vector<Number> numbers_;  ///< of the needed columns
};

}  // namespace

std::unique_ptr<table::Reader> with_derived_times(std::unique_ptr<table::Reader> table) {
  std::vector<Derived> derived = derived_times(table->header());
  std::vector<Counter> counters = counters_in(table->header());
  if (derived.empty() && counters.empty()) return table;
  return std::make_unique<DerivedTimes>(std::move(table), std::move(derived), std::move(counters));
}

table::BadTable unknown_rate(const table::Header& header, const std::string& numbers) {
  return {
      header.file,
      fmt::format("its rows are numbered by {}, but nothing states their rate", numbers),
      "state it in a comment above the names, such as '# frame rate: 100 Hz', or name the column "
      "of the time"};
}

std::optional<std::size_t> frame_column(const table::Header& header) {
  for (std::size_t column = 0; column < header.names.size(); ++column) {
    const Words words = words_of(header.names[column]);
    const bool is_counter = has_any(words, {"frame", "frames", "sample", "samples"}) ||
                            words == Words{"packet", "counter"} || words == Words{"counter"} ||
                            words == Words{"index"};
    const bool is_known =
        has_only(words, {"frame", "frames", "sample", "samples", "packet", "counter", "index",
                         "number", "num", "no", "nr", "id", "idx", "count"});
    if (is_counter && is_known) return column;
  }
  return std::nullopt;
}

}  // namespace twrench::recording

#include "recording/time_choice.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <map>
#include <string>

#include "base/words.h"
#include "recording/columns/columns.h"
#include "recording/columns/derived_times.h"
#include "recording/columns/stated_unit.h"
#include "recording/conventions/units.h"
#include "table/error.h"

namespace twrench::recording {
namespace {

/// The times of the first rows.
struct Times {
  std::size_t column = 0;
  std::vector<table::Number> numbers;  ///< none if a cell is not a number
  std::vector<double> since;           ///< since the first row, in the file's unit
};

Times times_of(const Recording& recording, std::size_t column) {
  Times times{column, {}, {}};
  try {
    const RowSample& sample = recording.first_rows({column});
    const auto at = std::ranges::find(sample.columns, column) - sample.columns.begin();
    for (const auto& row : sample.rows) {
      times.numbers.push_back(row[static_cast<std::size_t>(at)]);
      const table::Number &first = times.numbers.front(), &number = times.numbers.back();
      times.since.push_back((number.value - first.value) + (number.rest - first.rest));
    }
  } catch (const table::BadTable&) {
    times = {column, {}, {}};  // other columns may do, or else the rows are read again
  }
  return times;
}

bool do_increase(const Times& times) {
  return times.since.size() > 1 &&
         std::ranges::adjacent_find(times.since, std::greater_equal()) == times.since.end();
}

/// How well a name suits the time of the rows: lower is better.
enum class NameRank { of_sample, plain, other };

NameRank rank_of(const std::string& name) {
  const std::vector<std::string> words = stated_unit(words_of(name)).other_words;
  const auto is_there = [&](const char* word) {
    return std::ranges::find(words, word) != words.end();
  };
  if (is_there("sample") || is_there("header")) return NameRank::of_sample;
  const bool is_plain = std::ranges::any_of(
      std::initializer_list<const char*>{"t", "time", "timestamp", "stamp"}, is_there);
  return is_plain && words.size() == 1 ? NameRank::plain : NameRank::other;
}

/// One unit of the last digit that is written.
double last_place(const Times& times) {
  int decimals = 0;
  for (const table::Number& number : times.numbers) {
    if (number.decimals != table::Number::all_digits)
      decimals = std::max(decimals, number.decimals);
  }
  return std::pow(10.0, -decimals);
}

/// Whether both have the same intervals, in units that may differ.
bool have_same_intervals(const Times& a, const Times& b) {
  if (a.since.size() != b.since.size() || a.since.size() < 2) return false;
  const double ratio = a.since.back() / b.since.back();
  const double allowed = last_place(a) + ratio * last_place(b);
  const double power = std::pow(10.0, std::nearbyint(std::log10(ratio)));
  if (std::abs(ratio / power - 1) * a.since.back() > allowed) return false;
  for (std::size_t i = 0; i < a.since.size(); ++i) {
    if (std::abs(a.since[i] - power * b.since[i]) > allowed) return false;
  }
  return true;
}

/// The times among which the numbers leave a choice.
std::vector<Times> chosen(const table::Header& header, std::vector<Times> all) {
  if (std::ranges::any_of(all, do_increase))
    std::erase_if(all, [](const Times& one) { return !do_increase(one); });
  std::ranges::stable_sort(all, {},
                           [&](const Times& one) { return rank_of(header.names[one.column]); });
  const bool is_of_sample = rank_of(header.names[all.front().column]) == NameRank::of_sample;
  if (is_of_sample) {
    std::erase_if(all, [&](const Times& one) {
      return rank_of(header.names[one.column]) != NameRank::of_sample;
    });
  }
  const bool are_same = std::ranges::all_of(
      all, [&](const Times& one) { return have_same_intervals(all.front(), one); });
  if (are_same) all.resize(1);
  return all;
}

/// Throws if a column without a name numbers the rows.
void require_no_index(const table::Header& header, const Times& times) {
  if (!header.names[times.column].empty() || times.since.size() < 2) return;
  for (std::size_t i = 0; i < times.since.size(); ++i) {
    if (times.since[i] != static_cast<double>(i)) return;
  }
  throw unknown_rate(header, "its first column");
}

double median_interval(const Times& times) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < times.since.size(); ++i) {
    intervals.push_back(times.since[i] - times.since[i - 1]);
  }
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::ranges::nth_element(intervals, middle);
  return *middle;
}

/// Whether the file is a log of Betaflight, whose time is in us.
bool is_of_betaflight(const table::Header& header) {
  return std::ranges::find(header.names, "loopIteration") != header.names.end();
}

/// Whether the name means seconds unless it states another unit.
bool means_seconds(const std::string& name) {
  const std::vector<std::string> words = words_of(name);
  return std::ranges::all_of(words, [](const std::string& word) {
    return word == "t" || word == "time" || word == "sim" || word == "simulation" ||
           word == "elapsed";
  });
}

/// Whether the column counts as Xsens' SampleTimeFine does: 0.1 ms, or us in newer devices. None of
/// these samples faster than 1 kHz or slower than 10 Hz.
bool is_sample_time_fine(const std::string& name) {
  return words_of(name) == std::vector<std::string>{"sample", "time", "fine"};
}

/// The units that the numbers allow; none if they are seconds as usual.
std::vector<TimeUnit> units_of(const table::Header& header, const Times& times) {
  if (!do_increase(times)) return {};
  if (is_of_betaflight(header)) return {TimeUnit::us};
  const std::string& name = header.names[times.column];
  const double interval = median_interval(times);
  if (is_sample_time_fine(name)) {
    return {interval < 1000 ? TimeUnit::tenth_ms : TimeUnit::us};
  }
  constexpr double year_2001 = 1e9, year_2100 = 4.1e9;  // s since 1970
  constexpr double longest_in_s = 100, longest = 2, shortest = 5e-5;
  const double clock = std::abs(times.numbers.front().value);
  if (means_seconds(name) && clock < year_2100) return {};
  const bool are_whole = std::ranges::all_of(times.numbers, [](const table::Number& number) {
    return number.value == std::floor(number.value);
  });
  const bool may_be_seconds = clock < year_2100 && (!are_whole || interval <= longest_in_s);
  if (may_be_seconds && (!are_whole || interval < 1)) return {};
  std::vector<TimeUnit> possible, since_1970;
  for (const TimeUnit unit : {TimeUnit::s, TimeUnit::ms, TimeUnit::us, TimeUnit::ns}) {
    const double size = name_of(unit).in_s;
    const bool has_usual_rate = size * interval <= longest && size * interval >= shortest;
    const bool is_possible =
        size * clock < year_2100 && (unit == TimeUnit::s ? may_be_seconds : has_usual_rate);
    if (!is_possible) continue;
    possible.push_back(unit);
    if (size * clock >= year_2001) since_1970.push_back(unit);
  }
  return since_1970.size() == 1 ? since_1970 : possible;
}

}  // namespace

std::vector<Convention> with_times(const Recording& recording, std::vector<Convention> open) {
  const table::Header& header = recording.header();
  const auto column_of = [&](const Convention& convention) {
    return find_column(header, "t", convention.columns.at("t"));
  };
  std::vector<std::size_t> columns;
  for (const Convention& convention : open) columns.push_back(column_of(convention));
  std::ranges::sort(columns);
  columns.erase(std::ranges::unique(columns).begin(), columns.end());
  const bool is_settled = columns.size() == 1 && open.front().time_unit;
  if (is_settled) return open;
  std::vector<Times> all;
  for (const std::size_t column : columns) all.push_back(times_of(recording, column));
  if (all.size() > 1) all = chosen(header, std::move(all));
  if (all.size() == 1) require_no_index(header, all.front());
  std::vector<Convention> result;
  for (const Convention& convention : open) {
    const auto times = std::ranges::find(all, column_of(convention), &Times::column);
    if (times == all.end()) continue;
    std::vector<TimeUnit> units;
    if (!convention.time_unit) units = units_of(header, *times);
    if (units.empty()) result.push_back(convention);
    for (const TimeUnit unit : units) {
      result.push_back(convention);
      result.back().time_unit = unit;
    }
  }
  return result;
}

}  // namespace twrench::recording

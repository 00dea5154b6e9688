#include "recording/columns/summed_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "recording/columns/stated_unit.h"
#include "table/calendar.h"
#include "table/error.h"

namespace twrench::recording {
namespace {

using table::Calendar;
using table::Number;

constexpr std::string_view plus = " + ";

/// A time in two columns.
struct Sum {
  std::size_t first = 0, second = 0;
  double second_unit = 1;  ///< of the second column, s
  int decimals = 9;        ///< of the sum; not used for calendar times
};

/// A word for the fractions of a second, and how many of them a second has.
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
std::vector<Sum> sums_of_seconds(const table::Header& header) {
  std::vector<Sum> sums;
  for (std::size_t second = 1; second < header.names.size(); ++second) {
    std::vector<std::string> words = words_of(header.names[second]);
    if (words.empty()) continue;
    const auto* const fraction = std::ranges::find(fractions, words.back(), &Fraction::word);
    if (fraction == fractions.end()) continue;
    for (const char* seconds : {"sec", "secs", "seconds"}) {
      words.back() = seconds;
      const std::size_t first = second - 1;
      if (words_of(header.names[first]) != words) continue;
      sums.push_back({first, second, std::pow(10.0, -fraction->decimals), fraction->decimals});
    }
  }
  return sums;
}

/// A column of dates before one with the times of the day.
std::vector<Sum> sums_of_calendar(const table::Header& header) {
  std::vector<Sum> sums;
  for (std::size_t second = 1; second < header.names.size(); ++second) {
    const bool is_pair = header.calendar_of(second - 1) == Calendar::date &&
                         header.calendar_of(second) == Calendar::time_of_day;
    if (is_pair) sums.push_back({second - 1, second});
  }
  return sums;
}

class SummedTimes : public table::Reader {
 public:
  SummedTimes(std::unique_ptr<table::Reader> table, std::vector<Sum> sums)
      : table_(std::move(table)), sums_(std::move(sums)) {
    header_ = table_->header();
    const std::size_t columns = header_.names.size();
    header_.units.resize(columns);
    for (const Sum& sum : sums_) {
      header_.names.push_back(header_.names[sum.first] + std::string(plus) +
                              header_.names[sum.second]);
      header_.units.emplace_back("s");
      const bool is_calendar = header_.calendar_of(sum.second) != Calendar::none;
      if (!is_calendar) continue;
      header_.calendar.resize(header_.names.size());
      header_.calendar.back() = Calendar::date_time;
    }
  }

  void begin_pass(std::span<const std::size_t> columns) override {
    const std::size_t in_table = table_->header().names.size();
    std::vector<std::size_t> needed;
    places_.clear();
    for (const std::size_t column : columns) {
      const Sum* const sum = column < in_table ? nullptr : &sums_[column - in_table];
      places_.push_back({needed.size(), sum});
      needed.push_back(sum ? sum->first : column);
      if (sum) needed.push_back(sum->second);
    }
    numbers_.resize(needed.size());
    table_->begin_pass(needed);
  }

  bool next(std::span<Number> numbers) override {
    if (!table_->next(numbers_)) return false;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Place& place = places_[i];
      const Number& number = numbers_[place.at];
      numbers[i] = place.sum ? sum_of(*place.sum, number, numbers_[place.at + 1]) : number;
    }
    return true;
  }

  std::string place() const override { return table_->place(); }

 private:
  /// The place of a selected column among the numbers of the table.
  struct Place {
    std::size_t at;
    const Sum* sum;  ///< null unless the next number has to be added
  };

  Number sum_of(const Sum& sum, const Number& first, const Number& second) const {
    constexpr double nanoseconds = 1e9;
    if (header_.calendar_of(sum.second) != Calendar::none) {
      const double size = (second.value * nanoseconds) + (second.rest * nanoseconds);
      return table::seconds_from(whole(sum.first, first, 9e9) * 1'000'000'000 + std::llround(size),
                                 std::clamp(second.decimals, 0, 9));
    }
    const long long seconds = whole(sum.first, first, 9e9);
    const double most = std::round(1 / sum.second_unit);
    const long long parts = whole(sum.second, second, most - 1);
    if (parts < 0) throw bad_part(sum.second, second, most - 1);
    return table::seconds_from(
        seconds * 1'000'000'000 + parts * std::llround(nanoseconds * sum.second_unit),
        sum.decimals);
  }

  long long whole(std::size_t column, const Number& number, double most) const {
    const bool is_whole = number.value == std::floor(number.value);
    if (!is_whole || std::abs(number.value) > most) throw bad_part(column, number, most);
    return std::llround(number.value);
  }

  table::BadTable bad_part(std::size_t column, const Number& number, double most) const {
    return {
        table::cell_place(place(), header_.names[column]),
        fmt::format("{} is no part of a time in two columns", number.value),
        fmt::format("it must be a whole number up to {:.0f}, or else name the column of the time",
                    most)};
  }

  std::unique_ptr<table::Reader> table_;
  std::vector<Sum> sums_;
  std::vector<Place> places_;  ///< of the selected columns
  std::vector<Number> numbers_;
};

}  // namespace

std::unique_ptr<table::Reader> with_summed_times(std::unique_ptr<table::Reader> table) {
  std::vector<Sum> sums = sums_of_seconds(table->header());
  std::ranges::copy(sums_of_calendar(table->header()), std::back_inserter(sums));
  if (sums.empty()) return table;
  return std::make_unique<SummedTimes>(std::move(table), std::move(sums));
}

std::optional<std::pair<std::size_t, std::size_t>> terms_of(const table::Header& header,
                                                            std::size_t column) {
  const std::string& name = header.names[column];
  const std::size_t at = name.find(plus);
  if (at == std::string::npos) return std::nullopt;
  for (std::size_t first = 0; first + 1 < column; ++first) {
    if (name == header.names[first] + std::string(plus) + header.names[first + 1]) {
      return std::pair{first, first + 1};
    }
  }
  return std::nullopt;
}

}  // namespace twrench::recording

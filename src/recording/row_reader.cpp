#include "recording/row_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "recording/digits.h"
#include "recording/row_decoder.h"
#include "recording/steady_turn.h"
#include "table/calendar.h"
#include "table/error.h"

namespace twrench::recording {

struct RowReader::State {
  State(std::shared_ptr<table::Reader> opened, const Convention& meant, const Extract& part);

  bool next_of_extract();
  void require_extract() const;

  void require_later(const Row& row) const;
  table::Calendar calendar() const;
  bool has_calendar() const { return calendar() != table::Calendar::none; }
  std::string time_text(const table::Number& time) const;

  std::shared_ptr<table::Reader> reader;
  Convention convention;
  Extract extract;
  RowDecoder decoder;
  std::optional<table::Number> start;  ///< time of the table's first row
  std::vector<table::Number> numbers;
  std::size_t rows = 0;
  double last_time = 0;       ///< as in Row
  table::Number last_number;  ///< the same as the file has it
  TimeDigits time_digits;
  Digits rate_digits, attitude_digits;
  SteadyTurn steady_turn;
  double largest_momentum = 0;  ///< of the components, in the file's unit
};

RowReader::State::State(std::shared_ptr<table::Reader> opened, const Convention& meant,
                        const Extract& part)
    : reader(std::move(opened)),
      convention(meant),
      extract(part),
      decoder(reader->header(), convention, [this] { return reader->place(); }),
      numbers(decoder.columns().size()),
      time_digits(has_calendar() ||
                  !reader->header().sources_of(decoder.columns().front()).empty()) {
  reader->begin_pass(decoder.columns());
}

/// Reads the next row of the extract; returns false after it.
bool RowReader::State::next_of_extract() {
  double since_start = 0;
  do {
    if (!reader->next(numbers)) {
      require_extract();
      return false;
    }
    if (!start) start = numbers.front();
    since_start = decoder.seconds_between(*start, numbers.front());
  } while (since_start < extract.from);
  if (!(since_start > extract.to)) return true;  // decode() refuses times that are not finite
  require_extract();
  return false;
}

/// Throws BadTable if the table has rows, but none in the extract.
void RowReader::State::require_extract() const {
  if (!start || rows > 0) return;
  throw table::BadTable(reader->header().file,
                        fmt::format("no row is from {:.6g} to {:.6g} s after the first",
                                    std::max(extract.from, 0.0), extract.to),
                        "give other times");
}

void RowReader::State::require_later(const Row& row) const {
  constexpr double least = 1e-15;  // s, as of a method's steps
  if (rows == 0 || row.t - last_time >= least) return;
  const double t = numbers.front().value;
  const bool is_doubled = t == last_number.value || row.t == last_time;
  if (!is_doubled && row.t > last_time) {
    throw table::BadTable(
        table::cell_place(reader->place(), reader->header().names[decoder.columns().front()]),
        fmt::format(
            "the time {} is only {:.3g} s after that of the row before, but at least {:g} s "
            "are needed",
            t, row.t - last_time, least),
        "correct the row, or state the unit of the times");
  }
  throw table::BadTable(
      table::cell_place(reader->place(), reader->header().names[decoder.columns().front()]),
      fmt::format("the time {} {} of the row before{}", time_text(numbers.front()),
                  is_doubled ? "is that" : "is before that",
                  is_doubled ? "" : fmt::format(", {}", time_text(last_number))),
      is_doubled       ? "remove doubled rows, or write times with more digits"
      : has_calendar() ? "a clock goes back at midnight, at the end of summer time and at a leap "
                         "second: write times in UTC with their date, or give each part a file"
                       : "sort the rows by time, or give one run a file");
}

table::Calendar RowReader::State::calendar() const {
  return reader->header().calendar_of(decoder.columns().front());
}

std::string RowReader::State::time_text(const table::Number& time) const {
  if (calendar() == table::Calendar::none) return fmt::format("{}", time.value);
  return table::calendar_text(calendar(), time);
}

RowReader::RowReader(std::shared_ptr<table::Reader> table, const Convention& convention,
                     const Extract& extract)
    : state_(std::make_unique<State>(std::move(table), convention, extract)) {}

RowReader::~RowReader() = default;
RowReader::RowReader(RowReader&&) noexcept = default;
RowReader& RowReader::operator=(RowReader&&) noexcept = default;

bool RowReader::has_rates() const { return state_->decoder.has_rates(); }

double RowReader::first_time() const { return state_->decoder.first_time(); }

double RowReader::quaternion_length() const { return state_->decoder.quaternion_length(); }

AttitudeForm RowReader::attitude() const { return state_->decoder.attitude(); }

bool RowReader::next(Row& row) {
  State& state = *state_;
  if (!state.next_of_extract()) return false;
  if (state.rows == 0) state.decoder.set_first_row(state.numbers);
  state.decoder.decode(state.numbers, row);
  state.require_later(row);
  state.last_time = row.t;
  state.last_number = state.numbers.front();
  state.time_digits.add(state.numbers.front());
  for (const table::Number& rate : state.decoder.rates_in(state.numbers))
    state.rate_digits.add(rate);
  if (state.decoder.has_momentum()) {
    for (const table::Number& momentum : state.decoder.rates_in(state.numbers))
      state.largest_momentum = std::max(state.largest_momentum, std::abs(momentum.value));
  }
  for (const table::Number& number : state.decoder.attitude_in(state.numbers)) {
    state.attitude_digits.add(number);
  }
  row.number = ++state.rows;
  if (has_rates() && attitude() != AttitudeForm::none) state.steady_turn.add(row);
  return true;
}

std::string RowReader::place() const { return state_->reader->place(); }

Resolution RowReader::time_resolution() const {
  return state_->time_digits.resolution(state_->decoder.second());
}

Resolution RowReader::rate_resolution() const {
  const RowDecoder& decoder = state_->decoder;
  Resolution printed =
      state_->rate_digits.resolution(decoder.has_momentum() ? 1 : decoder.rate_unit());
  if (decoder.has_momentum()) {
    // Each rate may depend on all components, the largest included.
    printed.absolute = printed.at(state_->largest_momentum) * decoder.rates_of_unit_momentum();
    printed.relative = std::numeric_limits<double>::epsilon();
    printed.base = 2;
  }
  if (attitude() == AttitudeForm::none) return printed;
  const Resolution of_attitude = attitude_resolution();
  const bool has_all_digits = of_attitude.written == NumberFormat::float64;
  constexpr double quarters = 4;  // modified Rodrigues parameters have a quarter of the angle
  const Eigen::Vector3d& omega = state_->steady_turn.omega();
  double rate = printed.at(omega.cwiseAbs().maxCoeff());
  for (const double component : omega) {
    if (component != 0) rate = std::min(rate, printed.at(component));
  }
  const bool is_steady =
      state_->steady_turn.determines_rates(rate, quarters * of_attitude.at(std::numbers::pi));
  if (!is_steady && !(has_all_digits && state_->rate_digits.are_round())) return printed;
  Resolution exact;
  exact.unit = printed.unit;
  return exact;
}

Resolution RowReader::attitude_resolution() const {
  return state_->attitude_digits.resolution(state_->decoder.attitude_unit());
}

}  // namespace twrench::recording

#include "check/row_reader.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "check/attitude.h"
#include "check/column_sets.h"
#include "check/columns.h"
#include "check/digits.h"
#include "check/names.h"
#include "check/units.h"
#include "table/error.h"

namespace twrench::check {
namespace {

constexpr Kind kind_of(AttitudeForm form) {
  if (form == AttitudeForm::matrix) return Kind::matrix;
  return form == AttitudeForm::quaternion ? Kind::quaternion : Kind::euler;
}

/// How many seconds the file's unit of time has: 1e-3 where the name says ms.
double seconds_of(const table::Header& header, std::size_t column) {
  return stated_unit(header, column).seconds.value_or(1.0);
}

}  // namespace

struct RowReader::State {
  State(std::unique_ptr<table::Reader> opened, Convention meant);

  void select(Kind kind);
  void read_time(Row& row);
  void read_rates(Row& row);
  void read_attitude(Row& row);
  void read_matrix(Row& row);
  void read_quaternion(Row& row);
  void require_finite() const;
  table::BadTable bad_attitude(const std::string& why, const std::string& remedy) const;

  const std::string& name_of_column(std::size_t i) const {
    return reader->header().names[columns[i]];
  }

  std::span<const table::Number> numbers_of_attitude() const {
    return std::span(numbers).subspan(has_rates ? 4 : 1);
  }

  std::unique_ptr<table::Reader> reader;
  Convention convention;
  AttitudeForm form;
  bool has_rates;
  std::vector<std::size_t> columns;  ///< of the file, in the order in which they are read
  double second = 1, rate_unit = 1, euler_unit = 1;  ///< of the file, in ours
  Axes axes{2, 1, 0};
  std::vector<table::Number> numbers;
  std::size_t rows = 0;
  double last_time = 0;
  TimeDigits time_digits;
  Digits rate_digits, attitude_digits;
};

RowReader::State::State(std::unique_ptr<table::Reader> opened, Convention meant)
    : reader(std::move(opened)),
      convention(std::move(meant)),
      form(attitude_form(convention)),
      has_rates(check::has_rates(convention)) {
  const table::Header& header = reader->header();
  select(Kind::time);
  if (has_rates) select(Kind::rates);
  if (form != AttitudeForm::none) select(kind_of(form));
  if (convention.rates_in_space && has_rates && form == AttitudeForm::none) {
    throw InvalidArgument(header.file, "rates in space axes say nothing without an attitude",
                          "name the columns of the attitude");
  }
  const Angle angle = convention.unit.value_or(Angle::radians);
  rate_unit = radians_in(angle);
  euler_unit = radians_in(convention.euler_unit.value_or(angle));
  if (form == AttitudeForm::euler) {
    axes = axes_of(parse_sequence(convention.sequence, "the sequence of Euler angles"));
  }
  second = seconds_of(header, columns.front());
  reader->select(columns);
  numbers.resize(columns.size());
}

void RowReader::State::select(Kind kind) {
  const table::Header& header = reader->header();
  for (const std::string& ours : names_of(kind)) {
    const auto theirs = convention.columns.find(ours);
    if (theirs == convention.columns.end()) {
      throw ColumnError(header.file, ours, fmt::format("no column is named for {}", ours),
                        columns_remedy(header));
    }
    columns.push_back(find_column(header, ours, theirs->second));
  }
}

void RowReader::State::require_finite() const {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (std::isfinite(numbers[i].value)) continue;
    throw table::BadTable(table::cell_place(reader->place(), name_of_column(i)),
                          fmt::format("{} is not finite", numbers[i].value),
                          "remove the row, or end the file before it");
  }
}

void RowReader::State::read_time(Row& row) {
  time_digits.add(numbers[0]);
  row.t = second * numbers[0].value;
  if (rows > 0 && !(row.t > last_time)) {
    const bool is_doubled = row.t == last_time;
    throw table::BadTable(table::cell_place(reader->place(), name_of_column(0)),
                          fmt::format("the time {} {} of the row before{}", numbers[0].value,
                                      is_doubled ? "is that" : "is before that",
                                      is_doubled ? "" : fmt::format(", {}", last_time / second)),
                          is_doubled ? "remove doubled rows, or write times with more digits"
                                     : "sort the rows by time, or give one run a file");
  }
  last_time = row.t;
}

void RowReader::State::read_rates(Row& row) {
  for (int i = 0; i < 3; ++i) {
    const table::Number& number = numbers[static_cast<std::size_t>(1 + i)];
    rate_digits.add(number);
    row.omega[i] = rate_unit * number.value;
  }
}

table::BadTable RowReader::State::bad_attitude(const std::string& why,
                                               const std::string& remedy) const {
  return {fmt::format("{}: {}", reader->place(), description_of(kind_of(form))), why, remedy};
}

void RowReader::State::read_matrix(Row& row) {
  const auto entries = numbers_of_attitude();
  for (int i = 0; i < 9; ++i) row.X(i / 3, i % 3) = entries[static_cast<std::size_t>(i)].value;
  const Eigen::Vector3d lengths = row.X.rowwise().stableNorm();
  // Integrators that do not project drift, which is the judge's to say; beyond this it is something
  // else.
  if (!(lengths.minCoeff() > 1e-3 && lengths.maxCoeff() < 1e3)) {
    throw bad_attitude(
        fmt::format("its rows have the lengths {:.3g}, {:.3g} and {:.3g} instead of 1", lengths[0],
                    lengths[1], lengths[2]),
        "correct the row, or choose other columns");
  }
  const double determinant = row.X.determinant();
  // The product of the lengths is what rows at right angles would have.
  if (std::abs(determinant) < 0.01 * lengths.prod()) {
    throw bad_attitude(fmt::format("it is singular, with the determinant {:.3g}", determinant),
                       "correct the row, or choose other columns");
  }
  if (determinant < 0) {
    throw bad_attitude(
        fmt::format("it is a reflection and no rotation: its determinant is {:.3g}", determinant),
        "check the signs, and that both frames are right-handed");
  }
  row.orthogonality_error = (row.X.transpose() * row.X - Eigen::Matrix3d::Identity()).norm();
}

void RowReader::State::read_quaternion(Row& row) {
  std::array<double, 4> q{};
  for (std::size_t i = 0; i < 4; ++i) q[i] = numbers_of_attitude()[i].value;
  const double length = Eigen::Map<const Eigen::Vector4d>(q.data()).stableNorm();
  // As of matrices: what drifts is judged, and what is no quaternion is refused.
  constexpr double most = 0.1;
  if (!(std::abs(length - 1) <= most)) {
    throw bad_attitude(length == 0 ? "it is zero, which is no attitude"
                                   : fmt::format("its length is {:.6g} instead of 1", length),
                       "normalise it, or choose other columns");
  }
  row.X = rotation_by_quaternion(q);
  row.orthogonality_error = std::abs(length * length - 1);
}

void RowReader::State::read_attitude(Row& row) {
  for (const table::Number& number : numbers_of_attitude()) attitude_digits.add(number);
  if (form == AttitudeForm::matrix) read_matrix(row);
  if (form == AttitudeForm::quaternion) read_quaternion(row);
  if (form == AttitudeForm::euler) {
    std::array<double, 3> angles{};
    for (std::size_t i = 0; i < 3; ++i) angles[i] = euler_unit * numbers_of_attitude()[i].value;
    row.X = rotation_by_euler_angles(axes, angles);
  }
  if (convention.inverse) row.X.transposeInPlace();
}

RowReader::RowReader(const std::filesystem::path& file, const Convention& convention)
    : RowReader(table::open_table(file), convention) {}

RowReader::RowReader(std::unique_ptr<table::Reader> table, const Convention& convention)
    : state_(std::make_unique<State>(std::move(table), convention)) {}

RowReader::~RowReader() = default;
RowReader::RowReader(RowReader&&) noexcept = default;
RowReader& RowReader::operator=(RowReader&&) noexcept = default;

bool RowReader::has_rates() const { return state_->has_rates; }

AttitudeForm RowReader::attitude() const { return state_->form; }

Angle RowReader::rate_unit() const { return state_->convention.unit.value_or(Angle::radians); }

bool RowReader::next(Row& row) {
  State& state = *state_;
  if (!state.reader->next(state.numbers)) return false;
  state.require_finite();
  state.read_time(row);
  if (state.has_rates) state.read_rates(row);
  if (state.form != AttitudeForm::none) state.read_attitude(row);
  if (state.convention.rates_in_space && state.has_rates) {
    row.omega = (row.X.transpose() * row.omega).eval();
  }
  row.number = ++state.rows;
  return true;
}

std::string RowReader::place() const { return state_->reader->place(); }

Resolution RowReader::time_resolution() const {
  return state_->time_digits.resolution(state_->second);
}

Resolution RowReader::rate_resolution() const {
  return state_->rate_digits.resolution(state_->rate_unit);
}

Resolution RowReader::attitude_resolution() const {
  const bool is_angle = state_->form == AttitudeForm::euler;
  return state_->attitude_digits.resolution(is_angle ? state_->euler_unit : 1.0);
}

}  // namespace twrench::check

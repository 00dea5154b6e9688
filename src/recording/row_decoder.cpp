#include "recording/row_decoder.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "recording/columns/column_sets.h"
#include "recording/columns/columns.h"
#include "recording/conventions/names.h"
#include "recording/conventions/units.h"

namespace twrench::recording {
namespace {

using Eigen::Matrix3d;

double length_of(std::span<const table::Number> q) {
  return Eigen::Vector4d(q[0].value, q[1].value, q[2].value, q[3].value).stableNorm();
}

/// A quaternion that drifts is judged; any other is rejected, as with matrices.
constexpr double most_drift = 0.1;

/// How far the length of a quaternion may be from that of the first row, because both were rounded
/// or truncated to their last digits. Quaternions of varying length are no scaled rotations.
double allowed_for_rounding(std::span<const table::Number> q) {
  int decimals = std::numeric_limits<int>::min();
  bool are_whole = true;
  for (const table::Number& number : q) {
    decimals = std::max(decimals, number.decimals);
    are_whole = are_whole && number.value == std::trunc(number.value);
  }
  constexpr double places = 4, of_float32 = 1e-6;
  const double last_place = are_whole ? 1 : std::pow(10.0, -decimals);
  return places * last_place + of_float32 * length_of(q);
}

/// The first three numbers.
Eigen::Vector3d vector_of(std::span<const table::Number> numbers) {
  return {numbers[0].value, numbers[1].value, numbers[2].value};
}

/// Returns the index of a component in (w, x, y, z); nothing if the name is empty.
std::optional<std::size_t> index_of_component(const std::string& name) {
  if (name.empty()) return std::nullopt;
  const std::vector<std::string>& names = names_of(Kind::quaternion);
  return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
}

Matrix3d offset_of(const Convention& convention) {
  return convention.offset ? convention.offset->toRotationMatrix() : Matrix3d::Identity();
}

}  // namespace

// If the file's body axes are P times the program's, its attitude X_file takes components in its
// body axes to its space axes. If det P = -1, both frames of the file are left-handed. Any
// reflection makes the space frame right-handed again, because the file chooses that frame freely;
// -1 is used.
RowDecoder::RowDecoder(const table::Header& header, const Convention& convention,
                       std::function<std::string()> place)
    : form_(attitude_form(convention)),
      has_rates_(recording::has_rates(convention)),
      has_momentum_(recording::has_momentum(convention)),
      from_space_axes_(convention.rates_in_space && has_rates_),
      inverse_(convention.inverse),
      changes_axes_(convention.offset || convention.axes != BodyAxes()),
      negated_(index_of_component(convention.negated)),
      second_(name_of(time_unit(convention)).in_s),
      rate_unit_(name_of(recording::rate_unit(convention)).in_rad_s),
      unit_of_angles_(name_of(angle_unit(convention)).in_rad),
      rates_from_momentum_(convention.inertia.inverse()),
      body_from_file_(convention.axes.matrix().transpose()),
      turned_by_(body_from_file_.determinant() * offset_of(convention).transpose() *
                 convention.axes.matrix()),
      place_(std::move(place)) {
  select(header, convention, Kind::time);
  if (has_rates_) select(header, convention, has_momentum_ ? Kind::momentum : Kind::rates);
  if (const auto kind = kind_of(form_)) select(header, convention, *kind);
  if (from_space_axes_ && form_ == AttitudeForm::none) {
    throw InvalidArgument(header.file, "rates in space axes say nothing without an attitude",
                          "name the columns of the attitude");
  }
  if (form_ == AttitudeForm::euler) {
    sequence_ = axes_of(parse_sequence(convention.sequence, "the sequence of Euler angles"));
  }
}

void RowDecoder::select(const table::Header& header, const Convention& convention, Kind kind) {
  for (const std::string& ours : names_of(kind)) {
    const auto theirs = convention.columns.find(ours);
    if (theirs == convention.columns.end()) {
      throw ColumnError(header.file, ours, fmt::format("no column is named for {}", ours),
                        columns_remedy(header));
    }
    columns_.push_back(find_column(header, ours, theirs->second));
    names_.push_back(header.names[columns_.back()]);
  }
}

std::span<const table::Number> RowDecoder::rates_in(std::span<const table::Number> numbers) const {
  return numbers.subspan(1, has_rates_ ? 3 : 0);
}

std::span<const table::Number> RowDecoder::attitude_in(
    std::span<const table::Number> numbers) const {
  return numbers.subspan(has_rates_ ? 4 : 1);
}

void RowDecoder::set_first_row(std::span<const table::Number> numbers) {
  first_time_ = numbers[0];
  if (form_ != AttitudeForm::quaternion) return;
  const double length = length_of(attitude_in(numbers));
  constexpr double least = 1e-6, most = 1e20;  // of 64-bit integers
  const bool is_scaled = std::abs(length - 1) > most_drift && length >= least && length <= most;
  quaternion_length_ = is_scaled ? length : 1;
}

// The components of an axis have no unit.
double RowDecoder::attitude_unit() const {
  if (form_ == AttitudeForm::quaternion) return 1 / quaternion_length_;
  return has_angles(form_) && form_ != AttitudeForm::axis_angle ? unit_of_angles_ : 1.0;
}

void RowDecoder::decode(std::span<const table::Number> numbers, Row& row) const {
  require_finite(numbers);
  row.t = seconds_between(first_time_, numbers[0]);
  if (has_rates_) {
    for (int i = 0; i < 3; ++i) {
      row.omega[i] = rate_unit_ * rates_in(numbers)[static_cast<std::size_t>(i)].value;
    }
  }
  require_within_limits(numbers, row);
  if (form_ != AttitudeForm::none) decode_attitude(attitude_in(numbers), row);
  if (from_space_axes_) {
    row.omega = (body_from_file_.determinant() * row.X.transpose() * row.omega).eval();
  } else if (changes_axes_) {
    row.omega = (body_from_file_ * row.omega).eval();
  }
  if (has_momentum_) row.omega = (rates_from_momentum_ * row.omega).eval();
  if (has_rates_) require_speed(row);
}

void RowDecoder::require_finite(std::span<const table::Number> numbers) const {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (std::isfinite(numbers[i].value)) continue;
    throw table::BadTable(table::cell_place(place_(), names_[i]),
                          fmt::format("{} is not finite", numbers[i].value),
                          "remove the row, or truncate the file before it");
  }
}

/// The limits are those of scenes. Within them no square of a rate overflows or underflows.
void RowDecoder::require_within_limits(std::span<const table::Number> numbers,
                                       const Row& row) const {
  constexpr double longest = 1e15;  // s
  // Clocks may count nanoseconds since 1970, and their unit may not be known yet.
  constexpr double most_on_clock = 1e20;  // s
  constexpr double most = 1e12;           // rad/s, rad
  const auto require = [&](std::size_t i, double size, double limit, std::string_view unit,
                           const char* remedy) {
    if (std::abs(size) <= limit) return;
    throw table::BadTable(table::cell_place(place_(), names_[i]),
                          fmt::format("{:.3g} {} is beyond the limit of {:g} {}", size, unit, limit,
                                      unit.substr(0, unit.find(' '))),
                          remedy);
  };
  const char* const remedy_for_time = "correct the row, or state the unit of the times";
  require(0, second_ * numbers[0].value, most_on_clock, "s", remedy_for_time);
  require(0, row.t, longest, "s after the first row", remedy_for_time);
  const std::size_t rates = rates_in(numbers).size();
  for (std::size_t i = 1; i <= rates && !has_momentum_; ++i) {
    require(i, rate_unit_ * numbers[i].value, most, "rad/s", "correct or remove the row");
  }
  for (std::size_t i = rates + 1; has_angles(form_) && i < numbers.size(); ++i) {
    require(i, unit_of_angles_ * numbers[i].value, most, "rad", "correct or remove the row");
  }
}

void RowDecoder::require_speed(const Row& row) const {
  constexpr double least = 1e-100, most = 1e13;  // rad/s; the limits of the components are stricter
  const double square = row.omega.squaredNorm();
  if (square >= least * least && square <= most * most) return;
  const double speed = row.omega.stableNorm();
  if (speed == 0 || (speed >= least && speed <= most)) return;
  throw table::BadTable(place_(),
                        fmt::format("the rates have the magnitude {:.3g} rad/s, but must be zero "
                                    "or at least {:.3g} and at most {:.3g}",
                                    speed, least, most),
                        "write zeros if the body is at rest, or correct the unit");
}

void RowDecoder::decode_attitude(std::span<const table::Number> numbers, Row& row) const {
  switch (form_) {
    case AttitudeForm::none:
      return;
    case AttitudeForm::matrix:
      decode_matrix(numbers, row);
      break;
    case AttitudeForm::quaternion:
      decode_quaternion(numbers, row);
      break;
    case AttitudeForm::euler:
      decode_euler(numbers, row);
      break;
    case AttitudeForm::rotation_vector:
      row.X = rotation_by_vector(unit_of_angles_ * vector_of(numbers));
      break;
    case AttitudeForm::axis_angle:
      decode_axis_angle(numbers, row);
      break;
    case AttitudeForm::mrp:
      row.X = rotation_by_mrp(vector_of(numbers));
      break;
    case AttitudeForm::rodrigues:
      decode_rodrigues(numbers, row);
      break;
  }
  if (inverse_) row.X.transposeInPlace();
  if (changes_axes_) row.X = (row.X * turned_by_).eval();
}

table::BadTable RowDecoder::bad_attitude(const std::string& why, const std::string& remedy) const {
  return {fmt::format("{}: {}", place_(), description_of(*kind_of(form_))), why, remedy};
}

void RowDecoder::decode_matrix(std::span<const table::Number> entries, Row& row) const {
  for (int i = 0; i < 9; ++i) row.X(i / 3, i % 3) = entries[static_cast<std::size_t>(i)].value;
  Eigen::Vector3d lengths = row.X.rowwise().norm();
  // Integrators that do not project drift; judge() measures that. Such lengths are no drift.
  if (!(lengths.minCoeff() > 1e-3 && lengths.maxCoeff() < 1e3)) {
    lengths = row.X.rowwise().stableNorm();  // the squares may overflow
    throw bad_attitude(
        fmt::format("its rows have the lengths {:.3g}, {:.3g} and {:.3g} instead of 1", lengths[0],
                    lengths[1], lengths[2]),
        "correct the row, or choose other columns");
  }
  const double determinant = row.X.determinant();
  // Rows at right angles would have the product of their lengths as determinant.
  if (std::abs(determinant) < 0.01 * lengths.prod()) {
    throw bad_attitude(fmt::format("it is singular, with the determinant {:.3g}", determinant),
                       "correct the row, or choose other columns");
  }
  if (determinant < 0) {
    throw bad_attitude(
        fmt::format("it is a reflection, not a rotation: its determinant is {:.3g}", determinant),
        "check the signs, and that both frames are right-handed");
  }
  row.orthogonality_error = (row.X.transpose() * row.X - Matrix3d::Identity()).norm();
}

void RowDecoder::decode_quaternion(std::span<const table::Number> numbers, Row& row) const {
  std::array<double, 4> q{};
  for (std::size_t i = 0; i < 4; ++i) q[i] = numbers[i].value;
  if (negated_) q[*negated_] *= -1;
  const double length = Eigen::Map<const Eigen::Vector4d>(q.data()).stableNorm();
  const double relative = length / quaternion_length_;
  if (!(std::abs(relative - 1) <= most_drift)) throw bad_quaternion(length);
  if (quaternion_length_ != 1 &&
      std::abs(length - quaternion_length_) > allowed_for_rounding(numbers)) {
    throw bad_quaternion(length);
  }
  row.X = rotation_by_quaternion(q);
  row.orthogonality_error = std::abs(relative * relative - 1);
}

table::BadTable RowDecoder::bad_quaternion(double length) const {
  if (length == 0) {
    return bad_attitude("it is zero, which is not a valid attitude",
                        "remove the row, or choose other columns");
  }
  const bool is_scaled = quaternion_length_ != 1;
  return bad_attitude(fmt::format("its length is {:.6g} instead of {:.6g}{}", length,
                                  quaternion_length_, is_scaled ? " as in the first row" : ""),
                      "normalise it, or choose other columns");
}

void RowDecoder::decode_euler(std::span<const table::Number> numbers, Row& row) const {
  std::array<double, 3> angles{};
  for (std::size_t i = 0; i < 3; ++i) angles[i] = unit_of_angles_ * numbers[i].value;
  row.X = rotation_by_euler_angles(sequence_, angles);
}

void RowDecoder::decode_axis_angle(std::span<const table::Number> numbers, Row& row) const {
  const Eigen::Vector3d axis = vector_of(numbers);
  const double length = axis.stableNorm(), angle = unit_of_angles_ * numbers[3].value;
  constexpr double most = 0.1;  // as for quaternions
  if (angle != 0 && !(std::abs(length - 1) <= most)) {
    throw bad_attitude(fmt::format("the length of its axis is {:.6g} instead of 1", length),
                       "normalise it, or choose other columns");
  }
  // Without a rotation, there may be no axis.
  row.X = angle == 0 ? Matrix3d::Identity() : rotation_by_vector(angle / length * axis);
}

void RowDecoder::decode_rodrigues(std::span<const table::Number> numbers, Row& row) const {
  const Eigen::Vector3d g = vector_of(numbers);
  row.X = rotation_by_rodrigues(g);
  row.rodrigues_length = g.stableNorm();
}

}  // namespace twrench::recording

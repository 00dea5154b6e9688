#include "check/verdict/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "check/verdict/error.h"
#include "check/verdict/frame.h"
#include "check/verdict/stop.h"
#include "check/verdict/unit_change.h"
#include "math/rotation_between.h"
#include "recording/informative_rows.h"
#include "recording/row_reader.h"
#include "recording/rows.h"
#include "table/error.h"

namespace twrench::check {
namespace {

using recording::AttitudeForm;
using recording::Recording;
using recording::Row;
using recording::RowReader;

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Large enough to be worth the start of several threads.
constexpr std::size_t rows_per_block = 32768;

/// `reader` is a RowReader, or a UnitWatch, which reads from one.
template <typename Reader, typename Visit>
void for_each_block(Reader& reader, const std::atomic<bool>* stop, const Visit& visit) {
  std::vector<Row> block(rows_per_block);
  for (std::size_t count = rows_per_block; count == rows_per_block;) {
    throw_if_stopped(stop);
    count = 0;
    while (count < rows_per_block && reader.next(block[count])) ++count;
    if (count > 0) visit(std::span<const Row>(block.data(), count));
  }
}

/// A recording that is read in one convention.
struct ReadRecording {
  const Recording& recording;
  const recording::Convention& convention;
  bool has_rates = recording::has_rates(convention);
  bool has_attitude = attitude_form(convention) != AttitudeForm::none;

  /// Whether the initial state is fitted: as asked, or because differences of attitudes alone have
  /// too few digits to determine the initial rates.
  bool needs_fit(const Problem& problem) const {
    return problem.fit || (!has_rates && !problem.omega);
  }

  RowReader reader() const { return recording.rows(convention); }
};

Vector3d first_omega(const ReadRecording& read, const Problem& problem,
                     const std::vector<Row>& rows) {
  if (problem.omega) return *problem.omega;
  if (read.has_rates) return rows.front().omega;
  // With a single row, fit() throws.
  return rows.size() == 1 ? Vector3d::Zero() : omega_between(problem.inertia, rows[0], rows[1]);
}

/// The time at which omega holds, in s since the first row.
double start_of(const ReadRecording& read, const Problem& problem) {
  if (!problem.omega || !problem.omega_time) return 0;
  RowReader reader = read.reader();
  Row row;
  reader.next(row);
  return *problem.omega_time - reader.first_time();
}

Fit fitted(const ReadRecording& read, const Problem& problem) {
  recording::ThinnedRows thinned(most_fitted_rows);
  RowReader reader = read.reader();
  for_each_block(reader, problem.stop, [&](std::span<const Row> rows) {
    for (const Row& row : rows) thinned.add(row);
  });
  const std::vector<Row> first = beginning(read.recording, read.convention, 2);
  Vector3d omega = first_omega(read, problem, first);
  if (problem.omega) {
    omega = motion::ExactMotion({problem.inertia, omega}).at(-start_of(read, problem)).omega;
  }
  return fit(read.recording.name(), problem.inertia, thinned.rows(), omega, read.has_rates,
             read.has_attitude, problem.stop);
}

/// The given initial state, with the frame of the first row.
Reference given_reference(const ReadRecording& read, const Problem& problem) {
  const std::vector<Row> first = beginning(read.recording, read.convention, 1);
  const double start = start_of(read, problem);
  Reference reference{{problem.inertia, first_omega(read, problem, first)}, start};
  const Matrix3d X = motion::ExactMotion(reference.body).at(-start).X;
  reference.frame = nearest_rotation(first.front().X) * X.transpose();
  return reference;
}

/// The mean of L in the file's space, from its own rates if it has any.
Vector3d mean_momentum(const ReadRecording& read, const Reference& reference,
                       const std::atomic<bool>* stop) {
  const motion::ExactMotion exact(reference.body);
  ExactRows exact_rows;
  Vector3d sum = Vector3d::Zero();
  RowReader reader = read.reader();
  for_each_block(reader, stop, [&](std::span<const Row> rows) {
    exact_rows.evaluate(exact, reference.start, rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Vector3d omega = read.has_rates ? rows[i].omega : exact_rows.omega(i);
      sum += rows[i].X * (reference.body.inertia() * omega);
    }
  });
  return sum;
}

void turn_to_momentum(Reference& reference, const ReadRecording& read,
                      const std::atomic<bool>* stop) {
  const Vector3d mean = mean_momentum(read, reference, stop);
  const Vector3d L = reference.frame * reference.body.momentum();
  if (mean.norm() > 0 && L.norm() > 0)
    reference.frame = so3::rotation_between(L, mean).toRotationMatrix() * reference.frame;
}

/// The unit to which numbers were rounded, given the standard deviation of their errors, which are
/// independent and uniform.
double digit_of(double deviation) { return std::sqrt(12.0) * deviation; }

/// The standard deviation of errors that are independent from row to row; 0 if there are none.
double deviation_of(const std::vector<Span>& spans, DifferenceSums Span::*kind) {
  const std::size_t count = spans.size(), quarter = count / 4;
  return noise(sums(spans, kind, 0, count), sums(spans, kind, 0, quarter),
               sums(spans, kind, count - quarter, count))
      .value_or(0);
}

/// One unit of the last printed digit, or of the last digit that the program really has: if it has
/// fewer, the others are noise. Noise counts as digits only far below the errors of methods.
double digit(double printed, double scale, double deviation) {
  constexpr double most = 1e-10;
  return digit_of(deviation) > most * scale ? printed : std::max(printed, digit_of(deviation));
}

/// One unit of the last digit of an attitude as an angle, rad: for entries of about 1, or for the
/// largest angles. A quaternion and Rodrigues parameters contain half the angle, the modified ones
/// a quarter.
double printed_angle(const RowReader& reader) {
  const recording::Resolution resolution = reader.attitude_resolution();
  switch (reader.attitude()) {
    case AttitudeForm::none:
    case AttitudeForm::matrix:
      break;
    case AttitudeForm::quaternion:
    case AttitudeForm::rodrigues:
      return 2 * resolution.at(1);
    case AttitudeForm::mrp:
      return 4 * resolution.at(1);
    case AttitudeForm::euler:
    case AttitudeForm::rotation_vector:
      return resolution.at(std::numbers::pi);
    case AttitudeForm::axis_angle:
      return std::numbers::pi * resolution.at(1);
  }
  return resolution.at(1);
}

LastDigits digits_of(const RowReader& reader, const Comparison& comparison, const Noise& noise) {
  LastDigits digits;
  digits.time = reader.time_resolution();
  if (reader.has_rates()) {
    const double most = comparison.largest_rate();
    digits.printed_rate = reader.rate_resolution().at(most);
    digits.rate = digit(digits.printed_rate, most, noise.rate);
  }
  if (reader.attitude() != AttitudeForm::none) {
    digits.printed_attitude = printed_angle(reader);
    digits.attitude = digit(digits.printed_attitude, 1, noise.attitude);
  }
  return digits;
}

/// The digit of the attitudes in a span. Programs compute Rodrigues parameters from differences of
/// matrix entries, such as x32 - x23, which nearly cancel near half a turn: all the more of the
/// digits that numbers have in memory are lost, however many are printed.
double attitude_digit(const Judgement& judgement, const Span& span) {
  const recording::Resolution& printed = judgement.attitude_resolution;
  const double in_memory =
      printed.base == 2 ? printed.relative : std::numeric_limits<double>::epsilon();
  return std::max(judgement.digits.attitude, 2 * in_memory * span.rodrigues_length);
}

/// Sets the resolution limits of each span: how precisely the digits of the file and those of
/// doubles determine the motion.
void add_limits(Judgement& judgement, const Comparison& comparison) {
  std::vector<double> times;
  for (const Span& span : judgement.course)
    times.push_back(span.last.t - judgement.reference.start);
  const motion::FreeBody& body = judgement.reference.body;
  const LastDigits& digits = judgement.digits;
  const double speed = body.omega().norm();
  constexpr double round_off = 4 * std::numeric_limits<double>::epsilon();
  const double of_fit = judgement.fit ? 2 * round_off : 0;  // a fit ends where rounding hides more
  const double initial =
      (judgement.has_rates ? digits.rate : digits.attitude * speed) + of_fit * speed;
  const std::vector<Growth> growth = error_growth(body, times, initial);
  // The first row determines the frame.
  const double of_frame = attitude_digit(judgement, judgement.course.front()) + of_fit;
  judgement.within_digits = true;
  for (std::size_t i = 0; i < times.size(); ++i) {
    Span& span = judgement.course[i];
    const double time = digits.time.at(span.last.t) + round_off * std::abs(times[i]);
    span.rate_limit = initial * (1 + growth[i].rates) + comparison.largest_acceleration() * time;
    span.attitude_limit =
        of_frame + attitude_digit(judgement, span) + growth[i].attitude * initial + speed * time;
    const bool is_within = (!judgement.has_rates || span.rate_error <= span.rate_limit) &&
                           (!judgement.has_attitude || span.attitude_error <= span.attitude_limit);
    judgement.within_digits = judgement.within_digits && is_within;
  }
  judgement.growth = growth.back();
  judgement.rate_limit = judgement.course.back().rate_limit;
  judgement.attitude_limit = judgement.course.back().attitude_limit;
}

/// Whether the noise explains what the best initial state leaves.
bool is_noise_left_by(const Fit& fit, const Judgement& judgement) {
  // The fewer rows, the less precisely the noise is known.
  const double about = 1.2 * std::exp(2 / std::sqrt(static_cast<double>(judgement.rows)));
  const auto is_left = [&](const std::optional<double>& residual, double noise, double limit) {
    return !residual || *residual <= about * noise + limit;
  };
  return is_left(fit.rate_residual, judgement.noise.rate, judgement.rate_limit) &&
         is_left(fit.attitude_residual, judgement.noise.attitude, judgement.attitude_limit);
}

/// Whether the body turns so little from row to row that only noise scatters its errors: those of
/// methods are smooth.
bool are_errors_smooth(const Judgement& judgement) {
  constexpr double most = 0.5;  // rad per row
  const auto steps = static_cast<double>(std::max<std::size_t>(judgement.rows - 1, 1));
  return judgement.reference.body.omega().norm() * judgement.duration <= most * steps;
}

/// Whether the digits and the noise explain all errors: those of the rows, and that of the initial
/// state as the motion amplifies it.
bool are_noise(const Judgement& judgement, const ReadRecording& read, const Problem& problem) {
  const Noise& noise = judgement.noise;
  if (noise.rate == 0 && noise.attitude == 0) return false;
  const motion::FreeBody& body = judgement.reference.body;
  const double speed = body.omega().norm();
  constexpr double most = 0.1;  // more is no measurement of the motion
  if (noise.rate > most * speed || noise.attitude > most) return false;
  constexpr double deviations = 6;  // one number in 5e8 exceeds them
  const double rate = deviations * noise.rate, attitude = deviations * noise.attitude;
  const double of_first_row = judgement.has_rates ? rate : attitude * speed;
  const double initial =
      judgement.fit ? deviations * judgement.fit->omega_deviation.maxCoeff() : of_first_row;
  std::vector<double> times;
  for (const Span& span : judgement.course)
    times.push_back(span.last.t - judgement.reference.start);
  const std::vector<Growth> growth = error_growth(body, times, initial);
  const double grown =
      std::max(growth.back().rates / speed, judgement.has_attitude ? growth.back().attitude : 0);
  constexpr double much = 0.1;  // if errors grow so much, wrong motions are within the limits, too
  if (judgement.fit && !is_noise_left_by(*judgement.fit, judgement)) return false;
  if (initial * grown > much) {
    if (judgement.fit) return true;
    // Errors of more than half a turn hide the noise, which shows beside the motion that fits best.
    Problem of_fit = problem;
    of_fit.fit = true;
    return judge(read.recording, read.convention, of_fit).within_noise;
  }
  // The first row does not determine the frame of a fit.
  const double of_frame = judgement.fit && judgement.fit->frame_deviation
                              ? deviations * judgement.fit->frame_deviation->maxCoeff()
                              : 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const Span& span = judgement.course[i];
    const double rate_limit = span.rate_limit + rate + initial * growth[i].rates;
    const double attitude_limit =
        span.attitude_limit + of_frame + 2 * attitude + initial * growth[i].attitude;
    if (judgement.has_rates && span.rate_error > rate_limit) return false;
    if (judgement.has_attitude && span.attitude_error > attitude_limit) return false;
  }
  return true;
}

void take_sizes(Judgement& judgement, const Comparison& comparison, AttitudeForm form) {
  judgement.rows = comparison.rows();
  judgement.duration = comparison.last_time();
  judgement.energy_drift = comparison.energy_drift();
  judgement.energy_error = comparison.energy_error();
  if (judgement.has_rates) {
    judgement.rates = comparison.rates();
    judgement.first_rate_error = comparison.first_rate_error();
    judgement.momentum_drift = comparison.momentum_drift();
    judgement.momentum_error = comparison.momentum_error();
  }
  if (judgement.has_attitude) judgement.attitude = comparison.attitude();
  if (judgement.has_rates && judgement.has_attitude) {
    judgement.direction_drift = comparison.direction_drift();
  }
  if (form == AttitudeForm::matrix || form == AttitudeForm::quaternion) {
    judgement.orthogonality_error = comparison.orthogonality_error();
  }
}

/// Draws the conclusions from the errors after a pass.
void draw_conclusions(Judgement& judgement, Comparison& comparison, const ReadRecording& read,
                      const Problem& problem, const UnitWatch& units) {
  add_limits(judgement, comparison);
  judgement.flips =
      paired(comparison.flips().finish(), exact_flips(judgement.reference, 0, judgement.duration));
  judgement.more_flips = judgement.flips.size() >= FlipFinder::most;
  judgement.parts = error_parts(judgement.reference, judgement.course, judgement.has_attitude);
  // If the parts are larger than the whole, the phase was lost.
  constexpr double much_larger = 1.5;
  const double whole = judgement.rates ? judgement.rates->max : 0;
  if (judgement.parts && judgement.rates && judgement.parts->amplitude_rate > much_larger * whole) {
    judgement.parts.reset();
  }
  judgement.frame_turn = comparison.frame_turn();
  if (judgement.has_rates && judgement.has_attitude) {
    constexpr double margin = 3;  // between rows the error of the rates may be larger
    judgement.attitude_contradicts_rates =
        judgement.attitude->max >
        margin * (comparison.accumulated_rate_error() + judgement.attitude_limit);
  }
  judgement.within_noise = judgement.within_digits || are_noise(judgement, read, problem);
  constexpr double suspicious = 1e-3;
  if (judgement.within_noise || relative_error(judgement) < suspicious) return;
  units.require_one_unit();
  judgement.misfit =
      misfit(judgement.reference.body.inertia(), informative_rows(read.recording, read.convention),
             judgement.has_rates, judgement.has_attitude);
}

}  // namespace

Judgement judge(const Recording& recording, const recording::Convention& convention,
                const Problem& problem) {
  const ReadRecording read{recording, convention};
  std::optional<Fit> fit;
  if (read.needs_fit(problem)) fit = fitted(read, problem);
  Reference reference = fit ? fit->reference : given_reference(read, problem);
  if (problem.frame == FrameSource::momentum && read.has_attitude) {
    turn_to_momentum(reference, read, problem.stop);
  }
  Comparison comparison(reference, read.has_rates, read.has_attitude);
  RowReader reader = read.reader();
  UnitWatch units(reader, problem.inertia);
  for_each_block(units, problem.stop, [&](std::span<const Row> rows) { comparison.add(rows); });
  const std::size_t enough = problem.omega ? 1 : 3;
  const bool is_start_alone = comparison.rows() == 1 && reference.start == 0;
  if (comparison.rows() < enough || is_start_alone) {
    throw CheckError(recording.name(),
                     fmt::format("has {} {}, too few to determine a motion", comparison.rows(),
                                 comparison.rows() == 1 ? "row" : "rows"),
                     CheckError::Reason::one_row);
  }

  Judgement judgement{.convention = convention,
                      .has_rates = read.has_rates,
                      .has_attitude = read.has_attitude,
                      .first_time = reader.first_time(),
                      .reference = reference,
                      .is_start_given = problem.omega && !fit,
                      .fit = fit};
  take_sizes(judgement, comparison, reader.attitude());
  judgement.quaternion_length = reader.quaternion_length();
  const Noise scatter{deviation_of(comparison.spans(), &Span::rate_differences),
                      deviation_of(comparison.spans(), &Span::attitude_differences)};
  constexpr std::size_t enough_for_digits = 56;  // fewer hide that a single row is off
  judgement.digits =
      digits_of(reader, comparison, comparison.rows() < enough_for_digits ? Noise{} : scatter);
  if (are_errors_smooth(judgement)) judgement.noise = scatter;
  judgement.rate_resolution = reader.rate_resolution();
  judgement.attitude_resolution = reader.attitude_resolution();
  judgement.course = std::move(comparison.spans());
  draw_conclusions(judgement, comparison, read, problem, units);
  return judgement;
}

double clock_time(const Judgement& judgement, double t) { return judgement.first_time + t; }

double relative_error(const Judgement& judgement) {
  const double speed = judgement.reference.body.omega().norm();
  const double of_rates = judgement.rates && speed > 0 ? judgement.rates->max / speed : 0;
  return std::max(of_rates, judgement.attitude ? judgement.attitude->max : 0);
}

}  // namespace twrench::check

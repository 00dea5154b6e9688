#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "check/verdict/comparison.h"
#include "check/verdict/conditioning.h"
#include "check/verdict/fit.h"
#include "check/verdict/flips.h"
#include "check/verdict/phase.h"
#include "check/verdict/physics.h"
#include "check/verdict/problem.h"
#include "recording/conventions/convention.h"
#include "recording/digits.h"
#include "recording/recording.h"

namespace twrench::check {

/// One unit of the last digit of a file's numbers, in our units.
struct LastDigits {
  double rate = 0;      ///< rad/s: of the printed numbers, or of the noise if that is larger
  double attitude = 0;  ///< rad; likewise
  recording::Resolution time = {};  ///< of the times, s
  double printed_rate = 0;          ///< rad/s, of the printed numbers
  double printed_attitude = 0;      ///< rad, likewise
};

/// Standard deviations of errors that are independent from row to row; 0 if there are none.
struct Noise {
  double rate = 0;      ///< of the noisiest component of the rates, rad/s
  double attitude = 0;  ///< likewise, rad
};

/// The findings about a recorded trajectory. Times are in s since the first row.
struct Judgement {
  recording::Convention convention;
  bool has_rates = false, has_attitude = false;

  std::size_t rows = 0;
  double first_time = 0;  ///< of the first row on the file's clock, s
  double duration = 0;    ///< from the first row to the last

  Reference reference;          ///< the exact motion that it is compared with
  bool is_start_given = false;  ///< rather than taken from the rows
  std::optional<Fit> fit = {};

  std::optional<ErrorSize> rates = {}, attitude = {};  ///< rad/s and rad
  double first_rate_error = 0;  ///< largest component of the first row's error, rad/s
  double energy_drift = 0;
  std::optional<double> momentum_drift = {};       ///< of |L|, relative
  std::optional<double> direction_drift = {};      ///< of L in space, rad
  std::optional<double> orthogonality_error = {};  ///< of matrices and quaternions
  double quaternion_length = 1;                    ///< that all have, as in a file of integers
  double energy_error = 0;                         ///< against the exact motion, relative
  std::optional<double> momentum_error = {};       ///< likewise

  std::vector<Flip> flips = {};
  bool more_flips = false;  ///< whether there are more than are kept
  std::optional<ErrorParts> parts = {};

  Growth growth = {};  ///< of an initial error up to the last row
  LastDigits digits = {};
  recording::Resolution rate_resolution = {}, attitude_resolution = {};
  double rate_limit = 0;       ///< the resolution limit at the last row, rad/s
  double attitude_limit = 0;   ///< likewise, rad
  bool within_digits = false;  ///< whether no error is larger than the digits explain
  Noise noise = {};
  bool within_noise = false;  ///< whether the digits and the noise explain all errors
  std::vector<Span> course = {};

  /// Whether the attitude error exceeds what all errors of the rates can add up to.
  bool attitude_contradicts_rates = false;
  FrameTurn frame_turn = {};
  /// The misfit of the first rows, computed only if the errors are large.
  Misfit misfit = {};
};

/// Compares a recording with the exact motion, in memory that does not grow with its length. Throws
/// as RowReader does, table::BadTable if a unit changes between two rows, and CheckError if the
/// initial state is not determined or cannot be fitted.
Judgement judge(const recording::Recording& recording, const recording::Convention& convention,
                const Problem& problem);

/// Converts a time of a judgement to the file's clock, s.
double clock_time(const Judgement& judgement, double t);

/// Returns the largest error of the rates relative to |omega|, or of the attitude in rad if there
/// are no rates.
double relative_error(const Judgement& judgement);

}  // namespace twrench::check

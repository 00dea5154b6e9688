#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "check/conventions/convention.h"
#include "check/reading/resolution.h"
#include "check/verdict/comparison.h"
#include "check/verdict/conditioning.h"
#include "check/verdict/fit.h"
#include "check/verdict/flips.h"
#include "check/verdict/phase.h"
#include "check/verdict/physics.h"
#include "check/verdict/problem.h"

namespace twrench::check {

/// One unit of the last digit of a file's numbers, in our units.
struct LastDigits {
  double rate = 0;              ///< rad/s: of what is printed, or, where that is more, of the noise
  double attitude = 0;          ///< rad; likewise
  Resolution time = {};         ///< of the times, s
  double printed_rate = 0;      ///< rad/s, of what is printed
  double printed_attitude = 0;  ///< rad, likewise
};

/// Standard deviations of errors that are independent from row to row; 0 where there are none.
struct Noise {
  double rate = 0;      ///< of the component of the rates that has most, rad/s
  double attitude = 0;  ///< likewise, rad
};

/// What is found of a recorded trajectory. Times are as the file counts them, s.
struct Judgement {
  Convention convention;
  bool has_rates = false, has_attitude = false;

  std::size_t rows = 0;
  double first_time = 0, last_time = 0;

  Reference reference;          ///< what it is held against
  bool is_start_given = false;  ///< rather than taken from the rows
  std::optional<Fit> fit = {};

  std::optional<ErrorSize> rates = {}, attitude = {};  ///< rad/s and rad
  double first_rate_error = 0;  ///< of the first row: largest of the components, rad/s
  double energy_drift = 0;
  std::optional<double> momentum_drift = {};       ///< of |L|, relative
  std::optional<double> direction_drift = {};      ///< of L in space, rad
  std::optional<double> orthogonality_error = {};  ///< of matrices and quaternions
  double energy_error = 0;                         ///< against the exact motion, relative
  std::optional<double> momentum_error = {};       ///< likewise

  std::vector<Flip> flips = {};
  bool more_flips = false;  ///< than are kept
  std::optional<ErrorParts> parts = {};

  Growth growth = {};  ///< of an initial error until the last row
  LastDigits digits = {};
  Resolution rate_resolution = {}, attitude_resolution = {};
  double rate_limit = 0;       ///< the resolution limit at the last row, rad/s
  double attitude_limit = 0;   ///< likewise, rad
  bool within_digits = false;  ///< whether no error is larger than the digits explain
  Noise noise = {};
  bool within_noise = false;  ///< whether the digits and the noise explain all errors
  std::vector<Span> course = {};

  /// Whether the attitude is off by more than all errors of the rates can add up to.
  bool attitude_contradicts_rates = false;
  FrameTurn frame_turn = {};
  /// Of the first rows, where the errors are large.
  Misfit misfit = {};
};

/// Holds a recorded trajectory against the exact motion, in memory that does not grow with the
/// file. Throws as RowReader does, and CheckError where the initial state is not determined or
/// cannot be fitted.
Judgement judge(const std::filesystem::path& file, const Convention& convention,
                const Problem& problem);

/// Returns the largest error of the rates relative to |omega|, or of the attitude in rad where
/// there are no rates.
double relative_error(const Judgement& judgement);

}  // namespace twrench::check

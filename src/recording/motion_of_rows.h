#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <string>

#include "motion/recorded_motion.h"
#include "recording/conventions/convention.h"
#include "recording/recording.h"

namespace twrench::recording {

/// How a motion through rows treats their noise.
enum class Smoothing {
  none,          ///< The motion goes through the rows.
  within_noise,  ///< It is the smoothest one that differs from the rows by no more than their
                 ///< noise.
};

/// The standard deviations of errors that are independent from row to row, in each of three
/// components; nothing where the rows have no such errors.
struct RowNoise {
  std::optional<double> attitude;  ///< rad
  std::optional<double> rates;     ///< rad/s
};

/// The motion through the rows of a recording.
struct MotionOfRows {
  motion::RecordedMotion motion;
  /// Time of the first row that is shown, on the file's clock, in s.
  double clock_start = 0;
  bool has_rates = false, has_attitude = false;
  /// Number of intervals over which the motion is held, because they are longer than four usual
  /// ones.
  std::size_t gaps = 0;
  /// Estimated error of the last attitude in rad, if the attitudes are integrals of the rates.
  double drift = 0;
  RowNoise noise = {};
  /// The rows that are left out because they lack a number; empty if there are none.
  std::string left_out = {};
};

/// Reads the rows. With Smoothing, the attitudes and the rates of the rows are replaced by the
/// smoothest ones within their noise, those between two gaps by themselves. `start` is the attitude
/// of the first one, space_from_body, if the recording has none. Rates that are missing follow from
/// up to seven attitudes, to order 6. Attitudes that are missing follow from the rates by Magnus'
/// series of order 4 at Gauss' points, between which four rows are interpolated. Source: Iserles,
/// Munthe-Kaas, Norsett and Zanna, Lie-group methods, Acta Numerica 9 (2000), section 5. Throws as
/// RowReader does, and InvalidArgument about the recording if fewer than two rows are shown or the
/// body may turn by more than half a turn between two rows.
MotionOfRows motion_of_rows(const Recording& recording, const Convention& convention,
                            const Eigen::Quaterniond& start = Eigen::Quaterniond::Identity(),
                            Smoothing smoothing = Smoothing::none);

}  // namespace twrench::recording

#pragma once

#include <Eigen/Geometry>
#include <cstddef>

#include "motion/recorded_motion.h"
#include "recording/conventions/convention.h"
#include "recording/recording.h"

namespace twrench::recording {

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
};

/// Reads the rows. `start` is the attitude of the first one, space_from_body, if the recording has
/// none. Rates that are missing follow from up to seven attitudes, to order 6. Attitudes
/// that are missing follow from the rates by Magnus' series of order 4 at Gauss' points, between
/// which four rows are interpolated. Source: Iserles, Munthe-Kaas, Norsett and Zanna, Lie-group
/// methods, Acta Numerica 9 (2000), section 5. Throws as RowReader does, and InvalidArgument about
/// the recording if fewer than two rows are shown or the body may turn by more than half a turn
/// between two rows.
MotionOfRows motion_of_rows(const Recording& recording, const Convention& convention,
                            const Eigen::Quaterniond& start = Eigen::Quaterniond::Identity());

}  // namespace twrench::recording

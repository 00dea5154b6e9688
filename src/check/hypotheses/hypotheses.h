#pragma once

#include <optional>
#include <vector>

#include "check/hypotheses/readings.h"
#include "check/law/mistakes.h"
#include "check/verdict/judge.h"
#include "check/verdict/problem.h"

namespace twrench::check {

/// Other readings of a file that does not follow the motion as it is read.
struct Alternatives {
  /// The readings with the fewest changes that fit. The data cannot distinguish them.
  std::vector<Reading> fitting = {};
  /// The reading with the least misfit, if none fits.
  std::optional<Reading> nearest = {};
  /// Wrong laws that the rows follow as they are read. Empty if the motion of a free body explains
  /// them as well in one of the readings that fit.
  WrongLaws laws = {};
};

/// Tests how well the first rows of a file follow the motion of the body if they are read
/// differently from `convention`: in other units of times, rates and angles, even of those that the
/// file states; as the inverse attitude; with rates in the other axes; with another order of the
/// quaternion's components or of the rotations of Euler angles; with the wrong sign of one
/// component of the quaternion; in other axes of the body, left-handed ones included; with the
/// attitude of a part that is fixed to the body. Tries each change alone and with the others.
/// Throws as RowReader does.
Alternatives alternatives(const recording::Recording& recording, const Problem& problem,
                          const recording::Convention& convention);

/// Does the same for a judged file that does not follow the motion, and tries wrong laws. A reading
/// fits only if all rows follow the motion in it, and no wrong law explains them far better. If the
/// rates follow the motion as they are read, only other readings of the attitude are tried. If the
/// file follows the motion roughly, because of errors or because the moments are nearly the same,
/// other readings must fit far better.
Alternatives better_readings(const recording::Recording& recording, const Problem& problem,
                             const Judgement& judgement);

}  // namespace twrench::check

#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "check/law/law.h"
#include "check/law/mistakes.h"

namespace twrench::check {

/// A mistake, and the law with it as a function of the numbers that are fitted.
struct Candidate {
  Mistake mistake;
  Eigen::VectorXd start;      ///< the numbers where the search begins
  Eigen::VectorXd scale;      ///< the size of a step that matters
  std::vector<double> usual;  ///< values that the first number usually has
  std::function<Law(const Law& before, const Eigen::VectorXd& numbers)> law;
};

/// The sizes of rows that scale the numbers of a law.
struct RowScales {
  double speed;        ///< largest |w|, rad/s
  double later_speed;  ///< the same without the first row, which may exceed a limit
  double step;         ///< mean time between rows, s
};

/// Every mistake in the law of the rates. A torque in space needs an attitude.
std::vector<Candidate> candidates_for_rates(const Eigen::Matrix3d& inertia, const RowScales& scales,
                                            bool has_attitude);

/// Every mistake that rates show which follow from attitudes. If the factors of the attitude's
/// equation are swapped, they are the rates in the axes of space, seen from the body.
std::vector<Candidate> candidates_for_attitude_alone(const Eigen::Matrix3d& inertia,
                                                     const RowScales& scales);

/// Every mistake in the law of the attitude.
std::vector<Candidate> candidates_for_attitude(const RowScales& scales);

}  // namespace twrench::check

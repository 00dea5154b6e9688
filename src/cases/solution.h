#pragma once

#include <twrench/motion/exact.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "cases/case.h"

namespace twrench::cases {

/// The exact state of a case at one time.
struct State {
  double t;                       ///< s
  Eigen::Vector3d omega;          ///< Body axes, rad/s.
  Eigen::Quaterniond quaternion;  ///< Space from body; its scalar is not negative.
  double energy;                  ///< In the unit of the moments, per s^2; constant.
  Eigen::Vector3d momentum;       ///< Space axes, in the unit of the moments, per s; constant.
};

/// The closed form of the motion of a case, as accurate as ExactMotion. The attitude at t = 0 is
/// the published one, or the identity if none is published.
class Solution {
 public:
  explicit Solution(const Case& problem);

  /// Returns the state at time t in s.
  State at(double t) const;

 private:
  motion::FreeBody body_;
  motion::ExactMotion motion_;
  Eigen::Quaterniond attitude_;
};

/// Returns the times in s of the exact values of a case, ascending: the start, the times of
/// published values, and the end.
std::vector<double> times_of(const Case& problem);

/// Returns the exact components of the published quantity, in its unit. Two quaternions describe an
/// attitude; the result is the one nearer to the published one.
std::vector<double> exact_components(const Published& published, const State& exact);

/// Returns the largest difference of a published component from the exact one, in its unit.
double largest_difference(const Published& published, const State& exact);

/// Returns whether each component is within half a unit of its last published digit of the exact
/// one.
bool is_right_to_its_digits(const Published& published, const State& exact);

/// Returns a case with its published values, the exact ones beside them, and the exact states at
/// times_of(). Rates are in rad/s unless a unit is beside them; quaternions have the scalar first.
nlohmann::ordered_json case_json(const Case& problem);

/// Returns the parameters of a case and its source.
nlohmann::ordered_json summary_json(const Case& problem);

}  // namespace twrench::cases

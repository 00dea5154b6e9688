#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>

namespace twrench::check {

/// Squares of the fourth and sixth differences of a sequence, component by component, each scaled
/// so that its mean is the variance where neighbours are independent.
struct DifferenceSums {
  Eigen::Array3d fourth = Eigen::Array3d::Zero();
  Eigen::Array3d sixth = Eigen::Array3d::Zero();
  double count = 0;

  void add(const DifferenceSums& other);
};

/// Takes a sequence apart into what is smooth and what changes from row to row: rounding to the
/// digits that a program really has, which may be fewer than it prints. Higher differences remove
/// the smooth part (More and Wild, Estimating computational noise, SIAM J. Sci. Comput. 33, 2011).
class DifferenceTable {
 public:
  /// Takes the next element, at time t in s. Returns nothing until there are seven that are equally
  /// spaced.
  std::optional<DifferenceSums> add(double t, const Eigen::Vector3d& value);

 private:
  std::array<double, 7> times_{};
  std::array<Eigen::Vector3d, 7> values_;
  std::size_t count_ = 0;
};

/// Returns the standard deviation of independent noise in the component that has most, given the
/// sums of a whole sequence and of its first and last quarters. Nothing where what is not smooth is
/// not independent from row to row, or grows: that is an error and no rounding.
std::optional<double> noise(const DifferenceSums& all, const DifferenceSums& first_quarter,
                            const DifferenceSums& last_quarter);

}  // namespace twrench::check

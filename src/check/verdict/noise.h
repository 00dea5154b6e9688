#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>

namespace twrench::check {

/// Sums of the squared fourth and sixth differences of a sequence, component by component. They are
/// scaled so that their means are the variance if neighbours are independent.
struct DifferenceSums {
  Eigen::Array3d fourth = Eigen::Array3d::Zero();
  Eigen::Array3d sixth = Eigen::Array3d::Zero();
  double count = 0;

  void add(const DifferenceSums& other);
};

/// Separates a sequence into a smooth part and a part that is independent from row to row, such as
/// the rounding to the digits that a program really has, which may be fewer than it prints. Higher
/// differences remove the smooth part (More and Wild, Estimating computational noise, SIAM J. Sci.
/// Comput. 33, 2011).
class DifferenceTable {
 public:
  /// Adds the next element, at time t in s. Returns nothing unless the last seven are equally
  /// spaced.
  std::optional<DifferenceSums> add(double t, const Eigen::Vector3d& value);

 private:
  std::array<double, 7> times_{};
  std::array<Eigen::Vector3d, 7> values_;
  std::size_t count_ = 0;
};

/// Returns the standard deviation of independent noise in the noisiest component, given the sums of
/// a whole sequence and of its first and last quarters. Returns nothing if there are too few rows,
/// or if the part that is not smooth is correlated from row to row or changes in size: that is an
/// error rather than rounding.
std::optional<double> noise(const DifferenceSums& all, const DifferenceSums& first_quarter,
                            const DifferenceSums& last_quarter);

}  // namespace twrench::check

#pragma once

#include <Eigen/Core>
#include <cmath>
#include <random>

namespace twrench::motion {

/// Random physically possible bodies (the triangle inequality holds), from needles to plates, of
/// any size.
class RandomBodies {
 public:
  Eigen::Vector3d moments() {
    const Eigen::Vector3d squares = Eigen::Vector3d(edge(), edge(), edge()).array().square();
    return std::exp(5 * normal_(random_)) * (Eigen::Vector3d::Constant(squares.sum()) - squares);
  }
  Eigen::Vector3d vector() { return {normal_(random_), normal_(random_), normal_(random_)}; }
  Eigen::Vector3d omega() { return std::exp(normal_(random_)) * vector(); }
  double between(double a, double b) { return a + (b - a) * uniform_(random_); }

 private:
  double edge() { return between(0.05, 1.05); }

  std::mt19937_64 random_{20250711};
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> uniform_;
};

}  // namespace twrench::motion

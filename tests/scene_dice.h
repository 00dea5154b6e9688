#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <random>

namespace twrench {

/// Random numbers that are the same with every standard library; the standard distributions are
/// not.
class SceneDice {
 public:
  SceneDice(std::uint32_t seed, std::uint32_t number) {
    std::seed_seq sequence{seed, number};
    engine_.seed(sequence);
  }

  /// In [low, high).
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }
  /// Log-uniform.
  double spread(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  }
  int whole(int low, int high) { return static_cast<int>(std::floor(uniform(low, high + 1.0))); }
  bool chance(double share) { return uniform(0, 1) < share; }
  Eigen::Vector3d vector(double low, double high) {
    const double x = uniform(low, high), y = uniform(low, high);
    return {x, y, uniform(low, high)};
  }
  template <typename Values>
  const auto& pick(const Values& values) {
    return values[static_cast<std::size_t>(whole(0, static_cast<int>(std::size(values)) - 1))];
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace twrench

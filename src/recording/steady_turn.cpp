#include "recording/steady_turn.h"

#include <twrench/math/so3.h>

#include <algorithm>
#include <numbers>

namespace twrench::recording {

void SteadyTurn::add(const Row& row) {
  if (row.number == 1) first_ = row;
  if (!is_steady_) return;
  const Eigen::Matrix3d turned = first_.X * so3::exp(row.t * first_.omega);
  farthest_ = std::max(farthest_, (row.X - turned).norm() / std::numbers::sqrt2);
  duration_ = row.t;
  constexpr double much = 1e-2;  // rad; spares the other rows this computation
  is_steady_ = row.omega == first_.omega && farthest_ < much;
}

bool SteadyTurn::determines_rates(double rate, double angle) const {
  constexpr double part = 1e-3;
  return is_steady_ && farthest_ <= angle && angle < part * rate * duration_;
}

}  // namespace twrench::recording

#include "page/shadow_balls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace twrench::page {
namespace {

using picture::Ball;

constexpr std::size_t most_balls = 64;  // as in web/picture/ground.frag

/// A ball with the total cross-section of both, at their weighted mean.
Ball together(const Ball& a, const Ball& b) {
  const double of_a = a.radius * a.radius, of_b = b.radius * b.radius;
  return {(of_a * a.centre + of_b * b.centre) / (of_a + of_b), std::sqrt(of_a + of_b)};
}

/// The change of the shadow if two balls are merged: the second moment of their cross-sections.
double cost(const Ball& a, const Ball& b) {
  const double of_a = a.radius * a.radius, of_b = b.radius * b.radius;
  return of_a * of_b / (of_a + of_b) * (a.centre - b.centre).squaredNorm();
}

/// Merges balls in pairs, each time the pair with the lowest cost. For each ball it stores the
/// later ball with which it costs least, because a search through all pairs each time would take
/// minutes for a body of hundreds of rods.
class Reduction {
 public:
  explicit Reduction(std::vector<Ball> balls) : balls_(std::move(balls)), best_(balls_.size()) {
    for (std::size_t i = 0; i < balls_.size(); ++i) find_best(i);
  }

  std::vector<Ball> down_to(std::size_t most) {
    while (balls_.size() > most) take_two_together();
    return std::move(balls_);
  }

 private:
  struct Best {
    double cost = std::numeric_limits<double>::infinity();
    std::size_t other = 0;
  };

  void find_best(std::size_t i) {
    best_[i] = {};
    for (std::size_t k = i + 1; k < balls_.size(); ++k) {
      const double found = cost(balls_[i], balls_[k]);
      if (found < best_[i].cost) best_[i] = {found, k};
    }
  }

  void take_two_together() {
    const auto least = std::ranges::min_element(best_, {}, &Best::cost);
    const auto first = static_cast<std::size_t>(least - best_.begin());
    const std::size_t second = least->other;
    balls_[first] = together(balls_[first], balls_[second]);
    balls_.erase(balls_.begin() + static_cast<std::ptrdiff_t>(second));
    best_.erase(best_.begin() + static_cast<std::ptrdiff_t>(second));
    for (std::size_t i = 0; i < balls_.size(); ++i) update(i, first, second);
  }

  /// Updates ball `i` after ball `second` was merged into ball `first` and removed.
  void update(std::size_t i, std::size_t first, std::size_t second) {
    Best& best = best_[i];
    if (i == first || best.other == first || best.other == second) {
      find_best(i);
      return;
    }
    if (best.other > second) --best.other;
    if (i > first) return;
    const double found = cost(balls_[i], balls_[first]);
    const bool is_better = found < best.cost || (found == best.cost && first < best.other);
    if (is_better) best = {found, first};
  }

  std::vector<Ball> balls_;
  std::vector<Best> best_;
};

}  // namespace

std::vector<picture::Ball> reduced_shadow_balls(std::span<const body::Part> parts) {
  return Reduction(picture::shadow_balls(parts)).down_to(most_balls);
}

}  // namespace twrench::page

#pragma once

#include <atomic>
#include <cstddef>

namespace twrench::mesh {

/// The amount of work that a search may do, in steps of about 10 ns. Counting steps rather than
/// time makes every machine stop at the same mesh. All threads of a search share the allowance;
/// whether it suffices does not depend on the order in which they take from it.
class Allowance {
 public:
  explicit Allowance(std::size_t steps) : left_(static_cast<std::ptrdiff_t>(steps)) {}

  void take(std::size_t steps) { left_ -= static_cast<std::ptrdiff_t>(steps); }
  bool is_used_up() const { return left_ < 0; }

 private:
  std::atomic<std::ptrdiff_t> left_;
};

/// A few seconds on one processor.
inline constexpr std::size_t usual_steps = 300'000'000;

}  // namespace twrench::mesh

#pragma once

#include <string>
#include <vector>

#include "app/output.h"
#include "scene/scene.h"

namespace twrench::app {

/// The times, in s, from 0 to the duration, both ends included, at the scene's rate of samples.
class RegularTimes {
 public:
  /// Throws InvalidArgument if there would be too many.
  explicit RegularTimes(const scene::Scene& scene);

  std::size_t size() const { return regular_ + (last_regular() < duration_ ? 1 : 0); }
  double operator()(std::size_t i) const {
    return i < regular_ ? static_cast<double>(i) / rate_ : duration_;
  }

 private:
  double last_regular() const { return static_cast<double>(regular_ - 1) / rate_; }

  double duration_, rate_;
  std::size_t regular_;
};

/// Writes the scene's motion, by its own method, as "csv" or "json" at those times, or at the
/// regular ones if there are none. Throws as integrate(), RegularTimes and Output::write().
void write_trajectory(Output& output, const scene::Scene& scene, const std::string& format,
                      const std::vector<double>& times);

}  // namespace twrench::app

#pragma once

#include <string>
#include <vector>

#include "app/terminal/output.h"
#include "scene/scene.h"

namespace twrench::app {

/// The times, in s, from 0 to the duration, both ends included, at the scene's rate of samples.
class RegularTimes {
 public:
  /// Throws InvalidArgument if there would be too many.
  explicit RegularTimes(const scene::Scene& scene);

  std::size_t size() const { return size_; }
  /// The last one is the duration itself, whatever the rounding of the rate.
  double operator()(std::size_t i) const {
    return i + 1 < size_ ? static_cast<double>(i) / rate_ : duration_;
  }

 private:
  double duration_, rate_;
  std::size_t size_;
};

/// Writes the scene's motion, by its own method, as "csv" or "json" at those times, or at the
/// regular ones if there are none. Throws as integrate(), RegularTimes and Output::write().
void write_trajectory(Output& output, const scene::Scene& scene, const std::string& format,
                      const std::vector<double>& times);

}  // namespace twrench::app

#pragma once

#include <twrench/motion/free_body.h>

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace twrench::interchange {

/// The times, in s, from 0 to the duration, both included, at the scene's sample rate.
class RegularTimes {
 public:
  /// Throws InvalidArgument if there would be too many.
  explicit RegularTimes(const scene::Scene& scene);

  std::size_t size() const { return size_; }
  /// The last time is the duration itself, whatever the rounding of the rate.
  double operator()(std::size_t i) const {
    return i + 1 < size_ ? static_cast<double>(i) / rate_ : duration_;
  }

 private:
  double duration_, rate_;
  std::size_t size_;
};

/// Receives text, piece by piece.
using Write = std::function<void(std::string_view)>;

/// Receives how many samples of how many are computed.
using Progress = std::function<void(std::size_t done, std::size_t total)>;

/// Writes the scene's motion, computed by its own method, as "csv", "json" or "npz" at those times,
/// or at RegularTimes if there are none. Calls `progress`, unless it is empty, after each sample of
/// a method that takes steps to regular times. Returns a note on a visible error at the latest
/// time, which JSON has as its "note"; usually empty. Throws as integrate(), RegularTimes and
/// `write` do.
std::string write_trajectory(const Write& write, const scene::Scene& scene,
                             const std::string& format, const std::vector<double>& times,
                             const Progress& progress = {});

/// Writes samples of the body's motion in that CSV format. Throws what `write` throws.
void write_csv(const Write& write, const motion::FreeBody& body,
               std::span<const motion::Sample> samples);

}  // namespace twrench::interchange

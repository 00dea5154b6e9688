#include <fmt/format.h>
#include <twrench/motion/exact_many.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "base/require.h"
#include "motion/exact_solution.h"

namespace twrench::motion {
namespace {

/// The amount of work that a thread takes at a time, in samples. Preparing a body costs about as
/// much as 50 samples.
constexpr std::size_t samples_at_once = 16384, samples_per_body = 50;

void require_count(const char* array, std::size_t size, std::size_t expected, const char* shape) {
  if (size == expected) return;
  throw InvalidArgument(array,
                        fmt::format("has {} numbers, but must have {}: {}", size, expected, shape));
}

/// Returns a part of an array; an empty span if the array is empty.
std::span<double> part_of(std::span<double> array, std::size_t first, std::size_t count) {
  return array.empty() ? array : array.subspan(first, count);
}

/// The bodies given by the two arrays.
class Bodies {
 public:
  Bodies(std::span<const double> inertia, std::span<const double> omega)
      : inertia_(inertia), omega_(omega), alike_(inertia.size() == 3) {
    if (omega.size() % 3 != 0) {
      throw InvalidArgument(
          "omega", fmt::format("has {} numbers, but must have three for each body", omega.size()));
    }
    if (!alike_) require_count("inertia", inertia.size(), omega.size(), "as many as omega, or 3");
    const auto bad_moment = std::ranges::find_if_not(
        inertia, [](double moment) { return moment > 0 && std::isfinite(moment); });
    if (bad_moment != inertia.end())
      require_positive(name("inertia", bad_moment - inertia.begin()).c_str(), *bad_moment);
    const auto bad_omega =
        std::ranges::find_if_not(omega, [](double component) { return std::isfinite(component); });
    if (bad_omega != omega.end())
      require_finite(name("omega", bad_omega - omega.begin()).c_str(), *bad_omega);
  }

  std::size_t size() const { return omega_.size() / 3; }

  ExactSolution motion(std::size_t i) const {
    const Eigen::Vector3d moments(&inertia_[alike_ ? 0 : 3 * i]), omega(&omega_[3 * i]);
    try {
      return ExactSolution(FreeBody(moments.asDiagonal(), omega));
    } catch (const InvalidArgument& refused) {
      const std::string why = std::string(refused.what()).substr(refused.quantity().size() + 2);
      throw InvalidArgument(fmt::format("{}[{}]", refused.quantity(), i), why);
    }
  }

 private:
  static std::string name(const char* array, std::ptrdiff_t index) {
    return fmt::format("{}[{}, {}]", array, index / 3, index % 3);
  }

  std::span<const double> inertia_, omega_;
  bool alike_;
};

}  // namespace

void exact_many(const ManyBodies& many, std::span<const double> times, const ManySamples& output,
                unsigned threads) {
  const Bodies bodies(many.inertia, many.omega);
  require_finite("times", times);
  const std::size_t m = times.size(), samples = bodies.size() * m;
  const std::span<double> X = output.X, omega = output.omega;
  if (!X.empty()) {
    require_count("samples.X", X.size(), 9 * samples, "3 x 3 for each body and time");
  }
  if (!omega.empty()) {
    require_count("samples.omega", omega.size(), 3 * samples, "3 for each body and time");
  }
  if (samples == 0) return;
  // Several threads share a body with many times, and each prepares it separately.
  const std::size_t stretch = std::min(m, samples_at_once), stretches = (m + stretch - 1) / stretch;
  const std::size_t grain =
      std::max<std::size_t>(1, samples_at_once / (stretch + samples_per_body));
  for_each_part(bodies.size() * stretches, grain, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t item = begin; item < end; ++item) {
      const std::size_t i = item / stretches, from = item % stretches * stretch;
      const std::size_t first = i * m + from, count = std::min(stretch, m - from);
      bodies.motion(i).at(times.subspan(from, count), part_of(X, 9 * first, 9 * count),
                          part_of(omega, 3 * first, 3 * count), 1);
    }
  });
}

void first_flip_times(const ManyBodies& many, std::span<double> first, unsigned threads) {
  const Bodies bodies(many.inertia, many.omega);
  require_count("first", first.size(), bodies.size(), "one for each body");
  constexpr std::size_t grain = samples_at_once / samples_per_body;
  for_each_part(bodies.size(), grain, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto flips = bodies.motion(i).flips();
      first[i] = flips ? flips->first : std::numeric_limits<double>::infinity();
    }
  });
}

}  // namespace twrench::motion

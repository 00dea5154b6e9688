#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

#include "motion/trajectory.h"

/// What a value of a scene may be, said once for scene files and for the command line.
namespace twrench::limits {

struct Limit {
  double low, high;
  std::string_view why_low = {};  ///< where that needs a word

  /// False for NaN and the infinities too.
  bool allows(double value) const;
  /// "at least 1 and at most 64"
  std::string describe() const;
};

inline constexpr double huge = 1e12;

// Within these, no product of what a body is described by overflows or underflows.
inline constexpr Limit length{1e-9, 1e6};        // cm
inline constexpr Limit density{1e-9, 1e6};       // g/cm^3
inline constexpr Limit moment{1e-60, 1e30};      // g cm^2
inline constexpr Limit coordinate{-huge, huge};  // cm, rad/s, and directions
inline constexpr Limit step{1e-15, 1e6};         // s
inline constexpr Limit tolerance{least_tolerance, 1,
                                 "the limit of double precision"};  // of the estimate E
inline constexpr Limit duration{1e-15, 1e9};                        // s
inline constexpr Limit fps{1e-9, 1000};                             // 1/s
inline constexpr Limit speed{1e-15, 1e6};                           // s of motion per s of film
inline constexpr Limit pixels{16, 16384};                           // whole
inline constexpr Limit samples{1, 64};                              // whole
inline constexpr Limit fraction{0, 1};
inline constexpr Limit roughness{0.05, 1};
inline constexpr Limit angle_of_view{0.05, 2.5};  // rad

inline constexpr Limit motion_blur{1, 256};  // poses, whole
inline constexpr Limit angle{-1e3, 1e3};     // rad, and rad/s of film
inline constexpr Limit elevation{-1.5707963267948966, 1.5707963267948966, "straight below"};  // rad
inline constexpr Limit distance{0.2, 20};
inline constexpr Limit trail_length{1e-15, 1e6};  // s of motion

/// Of the greatest principal moment to the least: the axes are known to 1e-15 times that, and
/// beyond 1e15 or so the least moment is not known at all.
inline constexpr double most_moment_ratio = 1e12;

/// rad/s: the square of a slower rotation, in an energy, would underflow.
inline constexpr double slowest_rotation = 1e-100;

inline constexpr std::size_t most_compared = 4;
inline constexpr int most_parts = 1000;
inline constexpr double most_frames = 10'000'000;

/// Returns `value`, or throws UsageError "WHAT: is VALUE, but must be ...".
double check(const Limit& limit, const std::string& what, double value);
Eigen::Vector3d check(const Limit& limit, const std::string& what, const Eigen::Vector3d& value);
/// An angular velocity, rad/s: each component is a coordinate, and the whole is zero or not slower
/// than slowest_rotation.
Eigen::Vector3d check_omega(const std::string& what, const Eigen::Vector3d& omega);
/// The principal moments, g cm^2, of one body: their ratio is limited too.
Eigen::Vector3d check_moments(const std::string& what, const Eigen::Vector3d& moments);
int check_whole(const Limit& limit, const std::string& what, double value);

}  // namespace twrench::limits

#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

#include "motion/trajectory.h"

/// What a value of a scene may be, said once for scene files and for the command line.
namespace twrench::limits {

struct Limit {
  double low, high;
  bool low_is_open = false;       ///< low itself is not allowed
  std::string_view why_low = {};  ///< where that needs a word

  /// False for NaN and the infinities too.
  bool allows(double value) const;
  /// "greater than 0 and at most 1000"
  std::string describe() const;
};

inline constexpr double huge = 1e12;

inline constexpr Limit length{0, 1e6, true};     // cm
inline constexpr Limit density{0, 1e6, true};    // g/cm^3
inline constexpr Limit moment{0, 1e30, true};    // g cm^2
inline constexpr Limit coordinate{-huge, huge};  // cm, rad/s, and directions
inline constexpr Limit step{0, 1e6, true};       // s
inline constexpr Limit tolerance{least_tolerance, 1, false,
                                 "double precision keeps no less"};  // of the estimate E
inline constexpr Limit duration{0, 1e9, true};                       // s
inline constexpr Limit fps{0, 1000, true};                           // 1/s
inline constexpr Limit speed{0, 1e6, true};                          // s of motion per s of film
inline constexpr Limit pixels{16, 16384};                            // whole
inline constexpr Limit samples{1, 64};                               // whole
inline constexpr Limit fraction{0, 1};
inline constexpr Limit roughness{0.05, 1};
inline constexpr Limit angle_of_view{0.05, 2.5};  // rad

inline constexpr Limit motion_blur{1, 256};  // poses, whole
inline constexpr Limit angle{-1e3, 1e3};     // rad, and rad/s of film
inline constexpr Limit elevation{-1.5707963267948966, 1.5707963267948966, false,
                                 "that is straight below"};  // rad
inline constexpr Limit distance{0.2, 20};
inline constexpr Limit trail_length{0, 1e6, true};  // s of motion

inline constexpr std::size_t most_compared = 4;
inline constexpr int most_parts = 1000;
inline constexpr double most_frames = 10'000'000;

/// Returns `value`, or throws UsageError "WHAT: is VALUE, but must be ...".
double check(const Limit& limit, const std::string& what, double value);
Eigen::Vector3d check(const Limit& limit, const std::string& what, const Eigen::Vector3d& value);
int check_whole(const Limit& limit, const std::string& what, double value);

}  // namespace twrench::limits

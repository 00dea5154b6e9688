#pragma once

#include <twrench/motion/trajectory.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <string_view>

/// The limits of a scene's values, shared by scene files and the command line.
namespace twrench::scene::limits {

struct Limit {
  /// The smallest and the largest allowed value.
  double low, high;
  /// A note on the lower limit, if it needs one.
  std::string_view why_low = {};
  /// Whether the value may also be infinite, which has a meaning of its own.
  bool or_infinite = false;

  /// Returns whether the value is within the limits; false for NaN and infinities, also if
  /// `or_infinite`.
  bool allows(double value) const;
  /// Describes the limits, for example "at least 1 and at most 64".
  std::string describe() const;
};

inline constexpr double huge = 1e12;

// Within these limits no product of a body's quantities overflows or underflows.
inline constexpr Limit length{1e-9, 1e6};        // cm
inline constexpr Limit length_or_none{0, 1e6};   // cm
inline constexpr Limit mesh_size{1e-9, 1e9};     // cm
inline constexpr Limit mesh_scale{1e-12, 1e12};  // cm per unit of the file
inline constexpr Limit density{1e-9, 1e6};       // g/cm^3
inline constexpr Limit mass{1e-40, 1e40};        // g
inline constexpr Limit moment{1e-60, 1e30};      // g cm^2
// No entry of a positive definite matrix exceeds the largest on its diagonal.
inline constexpr Limit matrix_entry{-moment.high, moment.high};  // g cm^2
inline constexpr Limit coordinate{-huge, huge};  // cm, rad/s, and components of directions
// I omega of a body within the limits above.
inline constexpr Limit angular_momentum{-moment.high * huge, moment.high* huge};  // g cm^2/s
inline constexpr Limit energy_loss_time{1e-15, 1e15, {}, true};                   // s
inline constexpr Limit step{1e-15, 1e15};                                         // s
inline constexpr Limit tolerance{motion::min_tolerance, 1,
                                 "the limit of double precision"};  // of the error estimate E
inline constexpr Limit duration{1e-15, 1e15};                       // s
inline constexpr Limit fps{1e-9, 1000};                             // 1/s
inline constexpr Limit speed{1e-15, 1e15};                          // s of motion per s of video
inline constexpr Limit pixels{16, 16384};                           // integer
inline constexpr Limit samples{1, 64};                              // integer
inline constexpr Limit fraction{0, 1};
inline constexpr Limit roughness{0.05, 1};
inline constexpr Limit angle_of_view{0.05, 2.5};  // rad

inline constexpr Limit motion_blur{1, 256};            // poses, integer
inline constexpr Limit angle{-1e3, 1e3};               // rad, and rad/s of video
inline constexpr Limit crease{0, 3.1415926535897932};  // rad
// rad
inline constexpr Limit elevation{-1.5707963267948966, 1.5707963267948966, "straight below"};
inline constexpr Limit distance{0.2, 20};
inline constexpr Limit trail_length{1e-15, 1e15};  // s of motion
inline constexpr Limit star_trail{0, 1000};        // s of video

inline constexpr Limit shot_length{1e-3, 1e6};                // s of video
inline constexpr Limit shot_transition{0, shot_length.high};  // s of video
inline constexpr Limit shot_speed{0, speed.high};             // s of motion per s of video
inline constexpr Limit shot_start{0, duration.high};          // s of motion

/// The largest allowed ratio of principal moments. The axes are known to 1e-15 times that ratio,
/// and beyond about 1e15 the smallest moment is not determined at all.
inline constexpr double max_moment_ratio = 1e12;

/// The slowest rotation in rad/s: the square of a slower one would underflow in the energy.
inline constexpr double min_rotation_rate = 1e-100;

/// The smallest angular momentum of a wheel in g cm^2/s: the square of a smaller one would
/// underflow.
inline constexpr double min_wheel_momentum = 1e-150;

inline constexpr std::size_t max_compared = 4;
inline constexpr std::size_t max_shots = 1000;
inline constexpr int max_parts = 1000;
inline constexpr std::size_t max_parts_of_shots = 50'000;  // each shot has a body
inline constexpr double max_frames = 10'000'000;

/// Returns `value`, or throws OutOfRange "WHAT: is VALUE, but must be ...".
double check(const Limit& limit, const std::string& what, double value);
Eigen::Vector3d check(const Limit& limit, const std::string& what, const Eigen::Vector3d& value);
/// Checks an angular velocity in rad/s: each component is a coordinate, and the magnitude is zero
/// or at least min_rotation_rate. Throws InvalidArgument.
Eigen::Vector3d check_omega(const std::string& what, const Eigen::Vector3d& omega);
/// Checks the angular momentum of a wheel in g cm^2/s: each component is within angular_momentum,
/// and the magnitude is zero or at least min_wheel_momentum. Throws InvalidArgument.
Eigen::Vector3d check_wheel(const std::string& what, const Eigen::Vector3d& momentum);
/// Returns the rotation of a quaternion (w, x, y, z) whose length is within 0.1 of 1, which allows
/// numbers with few digits. Throws InvalidArgument.
Eigen::Quaterniond check_rotation(const std::string& what, const Eigen::Vector4d& quaternion);
/// Checks the principal moments of a body in g cm^2, and their ratio. Throws InvalidArgument.
Eigen::Vector3d check_moments(const std::string& what, const Eigen::Vector3d& moments);
/// Checks that an inertia matrix in g cm^2 is symmetric to 1e-12 of its largest entry, and that
/// check_moments() allows its principal moments. Returns it exactly symmetric. Throws
/// InvalidArgument.
Eigen::Matrix3d check_inertia(const std::string& what, const Eigen::Matrix3d& inertia);
/// Returns the density in g/cm^3 of a body whose mass is `grams` and whose volume is in cm^3.
/// Throws InvalidArgument if the mass or the density exceeds its limits.
double density_of_mass(const std::string& what, double grams, double volume);
int check_whole(const Limit& limit, const std::string& what, double value);

}  // namespace twrench::scene::limits

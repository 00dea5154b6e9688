#pragma once

#include <twrench/motion/exact.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace twrench::cases {

/// A quantity of which a source publishes values. The names are those in case files.
enum class Quantity {
  omega,       ///< Angular velocity in body axes.
  mrp,         ///< Modified Rodrigues parameters, space from body, of length at most 1.
  quaternion,  ///< Quaternion, space from body, scalar first.
  momentum,    ///< Angular momentum in space axes.
};

/// Values that a source publishes for one time.
struct Published {
  /// The program that computed them, if a source has several results; otherwise empty.
  std::string by;
  /// Time in s.
  double time;
  /// Kind of the values.
  Quantity quantity;
  /// Their unit; empty for quaternions and Rodrigues parameters.
  std::string unit;
  /// The unit in that of the exact state: pi/180 for deg/s, otherwise 1.
  double unit_size;
  /// The components as published, with all their digits.
  std::vector<std::string> digits;
  /// The same as numbers.
  std::vector<double> values;
  /// The largest documented difference of a component from the exact motion, in `unit`; 0 if the
  /// values are right to their last digit.
  double deviation;
};

/// A published problem of the motion of a free rigid body.
struct Case {
  std::string name;    ///< "basilisk-spacecraft"
  std::string title;   ///< Short description of the body.
  std::string source;  ///< Authors or project, report or file, year if it is known.
  std::string url;     ///< Link to the source.
  std::string note;    ///< Remarks on the values, in several lines.
  /// Principal moments of inertia about the body's x, y and z axes, in `inertia_unit`.
  Eigen::Vector3d moments;
  /// As published; empty if the source states none.
  std::string inertia_unit;
  /// Angular velocity at t = 0 in body axes, as published, in `omega_unit`.
  Eigen::Vector3d published_omega;
  std::string omega_unit;  ///< "rad/s" or "deg/s"
  /// The same in rad/s.
  Eigen::Vector3d omega;
  /// Attitude at t = 0, space from body, of unit length; nothing if none is published.
  std::optional<Eigen::Quaterniond> attitude;
  double duration;  ///< Length of the published motion in s.
  std::vector<Published> published;
};

/// Returns the names of the built-in cases in alphabetical order.
std::vector<std::string> case_names();

/// Returns a built-in case. Throws InvalidArgument about `what` if there is no case of that name,
/// suggesting the nearest name.
Case load_case(const std::string& name, const std::string& what);

/// Returns the unit of the angular momentum of a case: "kg m^2/s"; "1/s" if its moments have no
/// unit.
std::string momentum_unit(const Case& problem);

/// Returns the unit of the energy of a case: "kg m^2/s^2"; "1/s^2" if its moments have no unit.
std::string energy_unit(const Case& problem);

/// Reads a case from TOML. Throws InvalidArgument "SOURCE:LINE: KEY: ..." about any mistake; the
/// name of the case is that of the file without its ending.
Case parse_case(std::string_view toml, const std::string& source);

/// Returns one unit of the last digit of a number as it is printed: 1e-3 for "0.125", 1e-8 for
/// "2.5e-07".
double last_digit(const std::string& digits);

/// The exact state of a case at one time.
struct State {
  double t;                       ///< s
  Eigen::Vector3d omega;          ///< Body axes, rad/s.
  Eigen::Quaterniond quaternion;  ///< Space from body; its scalar is not negative.
  double energy;                  ///< In the unit of the moments, per s^2; constant.
  Eigen::Vector3d momentum;       ///< Space axes, in the unit of the moments, per s; constant.
};

/// The closed form of the motion of a case, as accurate as ExactMotion. The attitude at t = 0 is
/// the published one, or the identity if none is published.
class Solution {
 public:
  explicit Solution(const Case& problem);

  /// Returns the state at time t in s.
  State at(double t) const;

 private:
  motion::FreeBody body_;
  motion::ExactMotion motion_;
  Eigen::Quaterniond attitude_;
};

/// Returns the times in s of the exact values of a case, ascending: the start, the times of
/// published values, and the end.
std::vector<double> times_of(const Case& problem);

/// Returns the exact components of the published quantity, in its unit. Two quaternions describe an
/// attitude; the result is the one nearer to the published one.
std::vector<double> exact_components(const Published& published, const State& exact);

/// Returns the largest difference of a published component from the exact one, in its unit.
double largest_difference(const Published& published, const State& exact);

/// Returns whether each component is within half a unit of its last published digit of the exact
/// one.
bool is_right_to_its_digits(const Published& published, const State& exact);

/// Returns a case with its published values, the exact ones beside them, and the exact states at
/// times_of(). Rates are in rad/s unless a unit is beside them; quaternions have the scalar first.
nlohmann::ordered_json case_json(const Case& problem);

/// Returns the parameters of a case and its source.
nlohmann::ordered_json summary_json(const Case& problem);

}  // namespace twrench::cases

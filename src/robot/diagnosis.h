#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/geometry.h"
#include "robot/robot.h"

namespace twrench::robot {

/// The mass properties of a link: mass in kg, centre in m in the frame of the link, inertia about
/// it in kg m^2 in the axes of the link.
struct LinkMass {
  double mass = 0.0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
};

/// Returns the mass properties that the file states.
LinkMass stated_mass(const Inertial& inertial);

/// Returns the second moments of the mass about its centre in kg m^2: the integral of r r^T dm. A
/// body exists if this matrix has no negative eigenvalue, which is the triangle inequality of the
/// principal moments.
Eigen::Matrix3d second_moments(const Eigen::Matrix3d& inertia);

/// Returns the moments about the principal axes, ascending.
Eigen::Vector3d principal_moments(const Eigen::Matrix3d& inertia);

/// Returns whether a body can have these mass properties, to a relative tolerance of 1e-6.
bool is_possible(const LinkMass& body);

/// The judgement on a link.
enum class Verdict {
  good,        ///< Nothing speaks against it.
  unstated,    ///< The file states no mass properties.
  doubtful,    ///< A body can have them, but not this one, or a mistake explains them better.
  impossible,  ///< No body has them.
};

/// A fault of a link's mass properties, or a mistake that explains them.
enum class Fault {
  not_finite,      ///< NaN or infinity.
  mass,            ///< The mass is zero or negative.
  moments,         ///< A moment is zero or negative.
  triangle,        ///< A moment exceeds the sum of the two others.
  centre_outside,  ///< The centre of mass is outside the convex hull of the geometry.
  too_large,       ///< Mass would have to lie outside the convex hull.
  too_small,       ///< The moments are a thousandth of those of a uniform body, or less.
  placeholder,     ///< All moments are the same power of ten.
  identity,        ///< A multiple of the identity.
  copied,          ///< The numbers of another link.
  products_sign,   ///< Products of inertia with the other sign.
  entries_order,   ///< Entries of the matrix at the places of others.
  about_origin,    ///< About the origin of the link instead of the centre of mass.
  shifted_twice,   ///< Moved from the origin to the centre of mass, though it was about that.
  frame,           ///< In other axes than the file says.
  inertia_unit,    ///< In another unit.
  mass_unit,       ///< The mass is in g.
  mass_twice,      ///< Multiplied by the mass twice.
  unit_mass,       ///< For a mass of 1 kg.
  density_twice,   ///< Multiplied by the density twice.
  unit_density,    ///< For a density of 1 kg/m^3 or that of water.
};

/// A fault with its evidence.
struct Finding {
  Fault fault;
  /// A sentence without its end: "the products of inertia have the other sign".
  std::string text;
  /// The mass properties without the fault; nothing if they do not follow.
  std::optional<LinkMass> undone = {};
  /// For a fault that explains the numbers: the greatest difference from the geometry's moments
  /// without it, relative to the greatest moment, and that geometry. Nothing if there is no
  /// geometry to compare with, so that the fault is only possible.
  std::optional<double> misfit = {};
  std::string model = {};
};

/// The agreement of mass properties with a geometry.
struct Agreement {
  std::string model;
  double misfit = 0.0;
};

/// The judgement on a link.
struct Diagnosis {
  Verdict verdict = Verdict::unstated;
  LinkMass body;
  Eigen::Vector3d moments = Eigen::Vector3d::Zero();  ///< Ascending, in kg m^2.
  /// A geometry of uniform density that has these properties.
  std::optional<Agreement> agreement = {};
  /// The faults, the worst first.
  std::vector<Finding> faults = {};
  /// Mistakes that explain them. If there are several, they explain them equally well.
  std::vector<Finding> mistakes = {};

  /// Returns whether the verdict is `doubtful` or `impossible`.
  bool is_bad() const { return verdict >= Verdict::doubtful; }
};

/// A robot and the judgement on its links.
struct JudgedRobot {
  Robot robot;
  // For each link:
  std::vector<LinkGeometry> geometries;
  std::vector<Diagnosis> diagnoses;
  /// The other files that were read: meshes, and those that the description includes.
  std::vector<std::filesystem::path> files;
  /// Notes on contents that were not read, one line each, beginning with the place.
  std::vector<std::string> notes;
};

/// Reads the meshes of a robot and judges its links. `packages` are folders in which packages and
/// models are looked for. A mesh that cannot be read is a note. Throws InvalidArgument about a
/// package that is no folder.
JudgedRobot judge_robot(Robot robot, const std::vector<std::filesystem::path>& packages);

}  // namespace twrench::robot

#pragma once

#include <twrench/body/mass_properties.h>

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

namespace twrench::motion {

/// A curve of constant energy on the sphere |mu| = 1, where mu = m/G is the direction of the
/// momentum in principal axes: the intersection of the sphere with the energy ellipsoid sum mu_i^2
/// / I_i = 2T/G^2 (Landau and Lifshitz, Mechanics, section 37). The curve is closed and circles the
/// axis of least or greatest moment; the momentum moves along it.
///
/// With omega_i = G mu_i / I_i it becomes the polhode, the path of omega in the body.
///
/// The functions of a level throw InvalidArgument about "moments" unless they are positive, finite,
/// ascending and not all equal, and about an invalid "axis"; OutOfRange about "energy" and "side".
struct EnergyLevel {
  Eigen::Vector3d moments;         ///< Principal moments in g cm^2, ascending, not all equal.
  double energy;                   ///< 2T/G^2 in 1/(g cm^2), from 1/moments[2] to 1/moments[0].
  body::PrincipalAxes::Axis axis;  ///< The axis that the curve circles: least or greatest.
  double side;                     ///< Sign of mu along that axis: 1 or -1.

  /// Returns the point whose other two components are proportional to the cosine and sine of `phi`,
  /// each scaled by its amplitude; phi from 0 to 2 pi traverses the curve once. Throws OutOfRange
  /// about "phi" unless it is finite.
  Eigen::Vector3d at(double phi) const;

  /// Returns whether motion along the curve comes to rest at the intermediate axis, or so close to
  /// it that no difference is visible.
  bool is_separatrix() const;
};

// `moments` are principal moments in g cm^2, ascending. The functions throw InvalidArgument about
// "moments" unless they are positive, finite and ascending.

/// Returns the level through the unit vector mu; nothing for a sphere, where every mu is at rest.
/// Throws InvalidArgument about "moments" as above and about "mu" unless its length is 1.
std::optional<EnergyLevel> level_through(const Eigen::Vector3d& moments, const Eigen::Vector3d& mu);

/// Returns `count` levels around each end of the axes of least and greatest moment, evenly spaced
/// where they cross the plane of the intermediate axis. There are none around an axis about which
/// no rotation is stable, such as the transverse axes of a symmetric body. Throws InvalidArgument
/// about "moments" as above and OutOfRange about a negative "count".
std::vector<EnergyLevel> level_family(const Eigen::Vector3d& moments, int count);

/// Returns the two unit vectors u for which the separatrix consists of the great circles cos(phi)
/// e_2 + sin(phi) u through the intermediate axis. Nothing for a symmetric body. Throws
/// InvalidArgument about "moments" as above.
std::optional<std::array<Eigen::Vector3d, 2>> separatrix(const Eigen::Vector3d& moments);

/// The annulus of the herpolhode: the range of distances from L within which the tip of omega moves
/// on the invariable plane, in units of the plane's distance omega . L/|L| from the centre.
struct Annulus {
  double inner;  ///< Least distance.
  double outer;  ///< Greatest distance.
};
/// Returns the annulus of the herpolhode for motion along the level.
Annulus herpolhode_annulus(const EnergyLevel& level);

}  // namespace twrench::motion

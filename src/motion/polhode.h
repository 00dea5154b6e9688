#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

namespace twrench {

/// A curve of constant energy on the sphere |mu| = 1, where mu = m/G is the direction of the
/// momentum in principal axes: the sphere's intersection with the ellipsoid of energy,
/// sum mu_i^2 / I_i = 2T/G^2 (Landau and Lifshitz, Mechanics, section 37). It is closed, circles
/// the axis of least or of greatest moment, and the momentum runs along it.
///
/// With omega_i = G mu_i / I_i it is the polhode, the path of omega in the body.
struct EnergyLevel {
  Eigen::Vector3d moments;  ///< principal, ascending, not all equal
  double energy;            ///< 2T/G^2, from 1/moments[2] to 1/moments[0]
  int axis;                 ///< that which it circles: 0 or 2
  double side;              ///< 1 or -1: the sign of mu along that axis

  /// The point where the other two components are as the cosine and the sine of `phi`, but for
  /// their amplitudes: once around from 0 to 2 pi.
  Eigen::Vector3d at(double phi) const;

  /// Whether the motion along it comes to rest at the intermediate axis, or so near to it that
  /// no one could see the difference.
  bool is_separatrix() const;
};

/// The level on which mu, of length 1, lies; nothing where every mu is at rest, on a sphere.
std::optional<EnergyLevel> level_through(const Eigen::Vector3d& moments, const Eigen::Vector3d& mu);

/// `count` levels around each end of the axes of least and of greatest moment, evenly spread where
/// they cross the intermediate axis' plane; none around an axis that has no stable rotation of its
/// own, as those of a symmetric body across its axis.
std::vector<EnergyLevel> level_family(const Eigen::Vector3d& moments, int count);

/// The separatrix is two great circles through the intermediate axis: the points
/// cos(phi) e_2 + sin(phi) u with these two unit vectors u. Nothing for a symmetric body.
std::optional<std::array<Eigen::Vector3d, 2>> separatrix(const Eigen::Vector3d& moments);

/// Between these distances from L the tip of omega moves, on the invariable plane, as multiples of
/// the plane's own distance omega . L/|L| from the centre: the annulus of the herpolhode.
struct Annulus {
  double inner, outer;
};
Annulus herpolhode_annulus(const EnergyLevel& level);

}  // namespace twrench

#pragma once

#include <twrench/body/mass_properties.h>

#include <Eigen/Core>

namespace twrench::page {

/// The starts of the motions that the article's figures show. web/article/body.js computes the same
/// for every value of their controls.
class FigureStart {
 public:
  /// The spin of the figures is as fast as that of a body with this inertia (g cm^2) and angular
  /// velocity (rad/s) about the principal axis about which it mainly turns. Throws as
  /// body::principal_axes() does.
  FigureStart(const Eigen::Matrix3d& inertia, const Eigen::Vector3d& omega);

  /// Returns the same spin of another body. Throws as body::principal_axes() does.
  FigureStart of_body(const Eigen::Matrix3d& inertia) const;

  /// Returns whether two moments differ too little for the figures, which then show another body.
  bool has_equal_moments() const;

  /// Returns the angular velocity in rad/s about an axis, with a push to the side, as a fraction of
  /// the spin.
  Eigen::Vector3d spun(body::PrincipalAxes::Axis axis, double push) const;

  /// Returns the angular velocity in rad/s in a direction between the axes: of least moment at 0,
  /// of the intermediate one at pi/2, of the greatest at pi.
  Eigen::Vector3d between(double angle) const;

  /// Returns the angular velocity in rad/s for which the intermediate axis leans from L by an angle
  /// in rad, in the direction in which the lean grows.
  Eigen::Vector3d leaning(double lean) const;

  /// Returns the angular momentum in g cm^2/s of a wheel along the intermediate axis, as a multiple
  /// of the least one that makes the rotation about that axis stable.
  Eigen::Vector3d wheel(double share) const;

 private:
  FigureStart(const body::PrincipalAxes& principal, double rate)
      : principal_(principal), rate_(rate) {}

  body::PrincipalAxes principal_;
  double rate_;  ///< rad/s
};

}  // namespace twrench::page

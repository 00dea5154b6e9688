#pragma once

#include <twrench/motion/free_body.h>

#include <Eigen/Core>
#include <vector>

namespace twrench::motion {

/// The energy of a body with a wheel as a function of the direction mu = m/G of its momentum:
/// f(mu) = (mu - eta) . D (mu - eta) / 2 with eta = h/G and D = I1 I^-1, in principal axes. The
/// momentum moves along curves of constant f on the sphere |mu| = 1 if no energy is lost, and from
/// higher to lower ones otherwise. Without a wheel, EnergyLevel describes these curves in closed
/// form.
class EnergyContours {
 public:
  /// A curve as points on the sphere. The last point of a closed curve equals the first.
  using Curve = std::vector<Eigen::Vector3d>;

  /// How f changes around an equilibrium.
  enum class Kind { minimum, saddle, maximum };

  /// A direction in which the momentum stays at rest in the body, so that the body spins steadily.
  struct Equilibrium {
    Eigen::Vector3d mu;
    Kind kind;
  };

  /// The body must not be at rest with L = 0.
  explicit EnergyContours(const FreeBody& body);

  /// Returns f at a direction.
  double energy(const Eigen::Vector3d& mu) const;

  /// Returns all isolated equilibria, minima first. There are two, four or six. If the wheel is
  /// along the axis of a symmetric body, a circle of them about this axis may be omitted.
  const std::vector<Equilibrium>& equilibria() const { return equilibria_; }

  /// Returns the closed curve through a direction; only this point, if it is an equilibrium.
  Curve through(const Eigen::Vector3d& mu) const;

  /// Returns the curves that leave the saddles and return to them.
  std::vector<Curve> separatrices() const;

  /// A closed curve and the extremum from which it was found.
  struct Level {
    Curve curve;
    Equilibrium extremum;
  };
  /// Returns closed curves that cover the sphere at distances of about `spacing` rad.
  std::vector<Level> family(double spacing) const;

 private:
  Eigen::Vector3d gradient(const Eigen::Vector3d& mu) const;
  Eigen::Vector3d gradient_along_sphere(const Eigen::Vector3d& mu) const;
  double step_at(const Eigen::Vector3d& mu) const;
  Eigen::Vector3d direction(const Eigen::Vector3d& mu) const;
  Eigen::Vector3d advanced(const Eigen::Vector3d& mu, double step, double level) const;
  void find_equilibria();
  void add_equilibrium(double multiplier, const Eigen::Vector3d& mu);
  Curve leaving(const Eigen::Vector3d& saddle, const Eigen::Vector3d& along) const;

  Eigen::Vector3d d_, eta_;
  double stiffness_;  ///< Bound of the change of the gradient per rad.
  std::vector<Equilibrium> equilibria_;
};

}  // namespace twrench::motion

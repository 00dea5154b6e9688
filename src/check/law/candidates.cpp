#include "check/law/candidates.h"

#include <twrench/body/mass_properties.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace twrench::check {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

VectorXd numbers(std::initializer_list<double> values) {
  VectorXd vector(static_cast<Index>(values.size()));
  std::ranges::copy(values, vector.begin());
  return vector;
}

/// A candidate with a single number.
template <typename Set>
Candidate candidate(Mistake mistake, double start, double scale, std::vector<double> usual,
                    Set set) {
  return {mistake, numbers({start}), numbers({scale}), std::move(usual),
          [set](const Law& before, const VectorXd& p) {
            Law law = before;
            set(law, p[0]);
            return law;
          }};
}

/// A candidate without a number to fit.
template <typename Set>
Candidate plain(Mistake mistake, Set set) {
  return {mistake, VectorXd(), VectorXd(), {}, [set](const Law& before, const VectorXd&) {
            Law law = before;
            set(law);
            return law;
          }};
}

Candidate of_inertia(Mistake mistake, const Matrix3d& inertia) {
  return plain(mistake, [inertia](Law& law) { law.inertia = inertia; });
}

Candidate torque(Mistake mistake, Vector3d Law::*torque, double scale) {
  return {mistake,
          Vector3d::Zero(),
          Vector3d::Constant(scale),
          {},
          [torque](const Law& before, const VectorXd& p) {
            Law law = before;
            law.*torque = p;
            return law;
          }};
}

/// Another body with the same principal axes: the logarithms by which two moments grow.
Candidate other_moments(const Matrix3d& inertia) {
  const body::PrincipalAxes principal = body::principal_axes(inertia);
  return {Mistake::moments,
          numbers({0, 0}),
          numbers({1, 1}),
          {},
          [principal](const Law& before, const VectorXd& p) {
            constexpr double most = 10;  // keeps the moments finite
            const Vector3d growth(1, std::exp(std::clamp(p[0], -most, most)),
                                  std::exp(std::clamp(p[1], -most, most)));
            Law law = before;
            law.inertia = principal.axes * principal.moments.cwiseProduct(growth).asDiagonal() *
                          principal.axes.transpose();
            return law;
          }};
}

Matrix3d with_other_products(const Matrix3d& inertia) {
  return 2 * Matrix3d(inertia.diagonal().asDiagonal()) - inertia;
}

}  // namespace

std::vector<Candidate> candidates_for_rates(const Matrix3d& inertia, const RowScales& scales,
                                            bool has_attitude) {
  const double speed = scales.speed;
  const double moment = inertia.diagonal().maxCoeff();
  const double torque_scale = moment * speed * speed;
  const auto set_factor = [](Law& law, double a) { law.gyroscopic = a; };
  std::vector<Candidate> candidates{
      candidate(Mistake::gyroscopic_factor, 1, 1, {-1, 0, 0.5, 2}, set_factor),
      candidate(Mistake::undivided, 1 / moment, 1 / moment, {1},
                [](Law& law, double a) {
                  law.division = Division::omitted;
                  law.gyroscopic = a;
                }),
      candidate(Mistake::multiplied, 1 / (moment * moment), 1 / (moment * moment), {1},
                [](Law& law, double a) {
                  law.division = Division::multiplied;
                  law.gyroscopic = a;
                }),
      torque(Mistake::body_torque, &Law::body_torque, torque_scale),
      candidate(Mistake::damping, 0, speed, {}, [](Law& law, double c) { law.damping = c; }),
      candidate(Mistake::quadratic_damping, 0, 1, {},
                [](Law& law, double d) { law.quadratic_damping = d; }),
      candidate(Mistake::speed_limit, scales.later_speed, speed, {},
                [](Law& law, double limit) { law.speed_limit = limit; }),
      other_moments(inertia)};
  if (has_attitude)
    candidates.push_back(torque(Mistake::space_torque, &Law::space_torque, torque_scale));
  candidates.push_back(of_inertia(Mistake::inverse_inertia, moment * moment * inertia.inverse()));
  const Matrix3d other = with_other_products(inertia);
  if (!other.isApprox(inertia)) candidates.push_back(of_inertia(Mistake::products_sign, other));
  return candidates;
}

std::vector<Candidate> candidates_for_attitude_alone(const Matrix3d& inertia,
                                                     const RowScales& scales) {
  std::vector<Candidate> candidates = candidates_for_rates(inertia, scales, true);
  candidates.push_back(
      plain(Mistake::swapped_factors, [](Law& law) { law.kinematics = Kinematics::space_rates; }));
  return candidates;
}

std::vector<Candidate> candidates_for_attitude(const RowScales& scales) {
  const auto with_kinematics = [](Kinematics kinematics) {
    return [kinematics](Law& law, double k) {
      law.kinematics = kinematics;
      law.attitude_factor = k;
    };
  };
  const double step = scales.step;
  std::vector<Candidate> candidates{
      candidate(Mistake::attitude_factor, 1, 1, {2, 0.5, -1, 0},
                with_kinematics(Kinematics::body_rates)),
      candidate(Mistake::swapped_factors, 1, 1, {1, 2, -1},
                with_kinematics(Kinematics::space_rates)),
      candidate(Mistake::delayed_rates, 0, step, {step / 2, step, -step / 2, -step},
                [](Law& law, double delay) { law.delay = delay; })};
  static constexpr std::array<std::array<int, 3>, 6> sequences{
      {{2, 1, 0}, {0, 1, 2}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}}};
  for (const auto& [first, second, third] : sequences) {
    const Eigen::Vector3i axes(first, second, third);
    candidates.push_back(plain(Mistake::integrated_angles, [axes](Law& law) {
      law.kinematics = Kinematics::integrated_angles;
      law.sequence = axes;
    }));
  }
  return candidates;
}

}  // namespace twrench::check

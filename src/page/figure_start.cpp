#include "page/figure_start.h"

#include <twrench/motion/stability.h>

#include <algorithm>
#include <cmath>

namespace twrench::page {
namespace {

using body::PrincipalAxes;
using Eigen::Vector3d;

constexpr double least_difference = 0.01;  // of two moments, as a fraction of the greatest

double rate_about_main_axis(const PrincipalAxes& principal, const Vector3d& omega) {
  const double rate = (principal.axes.transpose() * omega).cwiseAbs().maxCoeff();
  return rate > 0 ? rate : 1;
}

/// The principal axis with its largest component positive.
Vector3d positive(const Vector3d& axis) {
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  return axis[largest] < 0 ? Vector3d(-axis) : axis;
}

}  // namespace

FigureStart::FigureStart(const Eigen::Matrix3d& inertia, const Vector3d& omega)
    : principal_(body::principal_axes(inertia)), rate_(rate_about_main_axis(principal_, omega)) {}

FigureStart FigureStart::of_body(const Eigen::Matrix3d& inertia) const {
  return {body::principal_axes(inertia), rate_};
}

bool FigureStart::has_equal_moments() const {
  const Vector3d& moments = principal_.moments;
  const double difference = std::min(moments[1] - moments[0], moments[2] - moments[1]);
  return difference < least_difference * moments[2];
}

Vector3d FigureStart::spun(PrincipalAxes::Axis axis, double push) const {
  using enum PrincipalAxes::Axis;
  const auto side = axis == least ? intermediate : least;
  return rate_ * (positive(principal_.axes.col(axis)) + push * positive(principal_.axes.col(side)));
}

Vector3d FigureStart::between(double angle) const {
  const Vector3d along(std::max(std::cos(angle), 0.0), std::sin(angle),
                       std::max(-std::cos(angle), 0.0));
  return principal_.axes * (rate_ * along);
}

/// With i the intermediate axis, j that of the greatest and k that of the least moment, the lean
/// grows in the direction (sigma, 0, -b) of docs/theory.md.
Vector3d FigureStart::leaning(double lean) const {
  const Vector3d& moments = principal_.moments;
  const double sigma = motion::stability(moments, PrincipalAxes::intermediate, rate_).rate / rate_;
  const double b = moments[1] / moments[0] - 1, length = std::hypot(b, sigma);
  const Vector3d momentum(std::sin(lean) * sigma / length, std::cos(lean),
                          -std::sin(lean) * b / length);
  return principal_.axes * (moments[1] * rate_ * momentum.cwiseQuotient(moments));
}

Vector3d FigureStart::wheel(double share) const {
  return share * motion::stabilizing_wheel(principal_.moments, rate_) *
         spun(PrincipalAxes::intermediate, 0).normalized();
}

}  // namespace twrench::page

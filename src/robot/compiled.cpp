#include "robot/compiled.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace twrench::robot {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Principal moments and the axes that they are about.
struct Principal {
  Vector3d moments = Vector3d::Zero();
  Matrix3d axes = Matrix3d::Identity();
};

/// The moments of a diagonal matrix are not rounded, because MuJoCo does not round those of a
/// `diaginertia`, and the triangle inequality depends on their last digit for a flat body.
Principal principal_of(const Matrix3d& inertia) {
  if (inertia.isDiagonal(0.0)) return {inertia.diagonal()};
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(inertia);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

/// MuJoCo allows no rounding here.
bool violates_triangle(const Vector3d& moments) {
  return moments[0] + moments[1] < moments[2] || moments[1] + moments[2] < moments[0] ||
         moments[2] + moments[0] < moments[1];
}

/// Changes a body as mjCBody::Compile does in MuJoCo's src/user/user_objects.cc.
void change(const CompilerSettings& settings, Principal principal, LinkMass& body) {
  body.mass = std::max(body.mass, settings.least_mass);
  Vector3d& moments = principal.moments;
  const bool is_too_small = moments.minCoeff() < settings.least_moment;
  moments = moments.cwiseMax(settings.least_moment);
  if (settings.balances_moments && violates_triangle(moments)) {
    body.inertia = moments.mean() * Matrix3d::Identity();
  } else if (is_too_small) {
    body.inertia = principal.axes * moments.asDiagonal() * principal.axes.transpose();
  }
}

/// The properties of a link before settotalmass scales them.
std::optional<LinkMass> unscaled(const Link& link, const LinkGeometry& geometry,
                                 const std::optional<CompilerSettings>& settings) {
  LinkMass body;
  Principal principal;
  if (link.is_from_geometry) {
    const auto model = geometry.stated();
    if (!model) return std::nullopt;
    body = {*model->mass, model->body.centre, *model->mass * model->body.inertia};
    principal = principal_of(body.inertia);
  } else if (const auto& inertial = link.inertial) {
    body = stated_mass(*inertial);
    principal = principal_of(inertial->matrix());
    principal.axes = inertial->link_from_inertial * principal.axes;
  }
  if (settings) change(*settings, principal, body);
  return body;
}

std::optional<std::string> hidden_fault(const Inertial& inertial,
                                        const CompilerSettings& settings) {
  if (!inertial.matrix().allFinite()) return std::nullopt;
  const Vector3d moments = principal_of(inertial.matrix()).moments;
  // Without the settings, MuJoCo raises negative values to 0, but the judgement names them anyway.
  if (settings.least_mass > 0.0 && inertial.mass.value < settings.least_mass) {
    return fmt::format("boundmass raises the mass from {} kg to {} kg", inertial.mass.value,
                       settings.least_mass);
  }
  if (settings.least_moment > 0.0 && moments.minCoeff() < settings.least_moment) {
    return fmt::format("boundinertia raises the moment {:.4g} kg m^2 to {} kg m^2",
                       moments.minCoeff(), settings.least_moment);
  }
  if (settings.balances_moments && violates_triangle(moments)) {
    return fmt::format(
        "balanceinertia hides that the moments {:.4g}, {:.4g} and {:.4g} kg m^2 violate the "
        "triangle inequality: MuJoCo replaces each by their mean, {:.4g} kg m^2",
        moments[0], moments[1], moments[2], moments.mean());
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::optional<LinkMass>> compiled(const Robot& robot,
                                              const std::vector<LinkGeometry>& geometries) {
  std::vector<std::optional<LinkMass>> bodies;
  for (std::size_t i = 0; i < robot.links.size(); ++i)
    bodies.push_back(unscaled(robot.links[i], geometries[i], robot.compiler));
  if (!robot.compiler || !robot.compiler->total_mass) return bodies;
  double total = 0.0;
  for (const auto& body : bodies) {
    if (!body) return std::vector<std::optional<LinkMass>>(bodies.size());
    total += body->mass;
  }
  if (total == 0.0) return bodies;
  const double factor = *robot.compiler->total_mass / total;
  for (auto& body : bodies) body->mass *= factor, body->inertia *= factor;
  return bodies;
}

std::vector<std::string> hidden_faults(const Robot& robot) {
  std::vector<std::string> lines;
  if (!robot.compiler) return lines;
  for (const Link& link : robot.links) {
    if (!link.inertial || link.is_from_geometry) continue;
    const auto fault = hidden_fault(*link.inertial, *robot.compiler);
    if (!fault) continue;
    lines.push_back(fmt::format("{}:{}: body '{}': {}", robot.file.string(), link.inertial->line,
                                link.name, *fault));
  }
  if (robot.compiler->total_mass) {
    lines.push_back(
        fmt::format("{}: settotalmass scales all masses and moments to a total of {} kg",
                    robot.file.string(), *robot.compiler->total_mass));
  }
  return lines;
}

}  // namespace twrench::robot

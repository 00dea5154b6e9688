#include "robot/diagnosis.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "robot/compiled.h"
#include "robot/experiments.h"

namespace twrench::robot {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Robot descriptions are rounded, often to six digits.
constexpr double tolerance = 1e-6;

/// A body whose moments are this much smaller than those of a uniform one has nearly all of its
/// mass in its centre.
constexpr double much_smaller = 1e-3;

bool is_finite(const LinkMass& body) {
  return std::isfinite(body.mass) && body.centre.allFinite() && body.inertia.allFinite();
}

/// Half a unit of the last digit of the centre, in m.
double resolution_of_centre(const Inertial& inertial) {
  return std::ranges::max(inertial.centre, {}, &Written::resolution).resolution;
}

std::string list_of(const Vector3d& v) {
  return fmt::format("{:.4g}, {:.4g} and {:.4g}", v[0], v[1], v[2]);
}

/// Returns what makes the mass properties impossible for any body.
std::optional<Finding> impossibility(const LinkMass& body) {
  if (!is_finite(body)) {
    return Finding{Fault::not_finite, "a number is NaN or infinite"};
  }
  const Vector3d moments = principal_moments(body.inertia);
  if (!(body.mass > 0.0)) {
    const bool is_empty = body.mass == 0.0 && body.inertia.isZero(0.0);
    return Finding{Fault::mass, is_empty ? "the mass and the moments are zero"
                                         : fmt::format("the mass is {} kg", body.mass)};
  }
  if (body.inertia.isZero(0.0)) return Finding{Fault::moments, "the moments are zero"};
  if (moments[0] < -tolerance * moments[2] || moments[0] <= 0.0) {
    return Finding{Fault::moments, fmt::format("the principal moments are {} kg m^2, and moments "
                                               "are positive",
                                               list_of(moments))};
  }
  if (moments[2] > (moments[0] + moments[1]) * (1 + tolerance)) {
    return Finding{
        Fault::triangle,
        fmt::format("the greatest principal moment, {:.4g} kg m^2, exceeds the sum of the two "
                    "others, {:.4g} + {:.4g}",
                    moments[2], moments[1], moments[0])};
  }
  return std::nullopt;
}

/// Returns a direction along which the mass would have to lie farther out than the geometry: the
/// variance of a distribution between a and b with the mean m is at most (b - m)(m - a) (Bhatia and
/// Davis, Am. Math. Mon. 107 (2000) 353).
std::optional<Finding> too_large(const LinkMass& body, const LinkGeometry& geometry) {
  const Matrix3d second = second_moments(body.inertia) / body.mass;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(second);
  for (int i = 2; i >= 0; --i) {
    const Vector3d along = solver.eigenvectors().col(i);
    const double variance = solver.eigenvalues()[i];
    const double mean = body.centre.dot(along);
    const double most = (geometry.extent(along) - mean) * (mean + geometry.extent(-along));
    if (variance <= 1.01 * std::max(most, 0.0)) continue;
    return Finding{Fault::too_large,
                   fmt::format("the mass would lie {:.3g} m from the centre of mass (root mean "
                               "square), but the geometry allows {:.3g} m",
                               std::sqrt(variance), std::sqrt(std::max(most, 0.0)))};
  }
  return std::nullopt;
}

std::optional<Finding> too_small(const LinkMass& body, const LinkGeometry& geometry) {
  if (geometry.models().empty()) return std::nullopt;
  const Vector3d uniform = body.mass * principal_moments(geometry.models().front().body.inertia);
  const Vector3d moments = principal_moments(body.inertia);
  if ((moments.array() > much_smaller * uniform.array()).any()) return std::nullopt;
  return Finding{Fault::too_small,
                 fmt::format("the moments are {:.2g} times those of a uniform body of this mass",
                             moments[2] / uniform[2])};
}

std::optional<Finding> centre_outside(const Inertial& inertial, const LinkGeometry& geometry) {
  const Vector3d centre = inertial.centre_of_mass();
  const double distance = geometry.distance_outside(centre);
  const double size = geometry.extent(Vector3d::UnitX()) + geometry.extent(-Vector3d::UnitX());
  const double allowed = std::max(1e-3 * size, 2 * resolution_of_centre(inertial));
  if (distance <= allowed) return std::nullopt;
  return Finding{
      Fault::centre_outside,
      fmt::format("the centre of mass is {:.3g} m outside the convex hull of the geometry",
                  distance)};
}

bool is_power_of_ten(double x) {
  const double power = std::log10(x);
  return std::abs(power - std::round(power)) < 1e-9;
}

/// Returns whether all moments are equal, though those of the geometry are not.
std::optional<Finding> identity(const LinkMass& body, const LinkGeometry& geometry) {
  const double moment = body.inertia(0, 0);
  if (!body.inertia.isApprox(moment * Matrix3d::Identity(), 1e-9)) return std::nullopt;
  if (geometry.models().empty()) return std::nullopt;
  const Vector3d uniform = principal_moments(geometry.models().front().body.inertia);
  if (uniform[2] < 1.2 * uniform[0]) return std::nullopt;
  if (is_power_of_ten(moment)) {
    return Finding{Fault::placeholder,
                   fmt::format("all moments are {}, which is a placeholder", moment)};
  }
  return Finding{Fault::identity,
                 fmt::format("the matrix is a multiple of the identity, but the greatest moment "
                             "of the geometry is {:.3g} times its least",
                             uniform[2] / uniform[0])};
}

void add_doubts(const Inertial& inertial, const LinkGeometry& geometry, Diagnosis& diagnosis) {
  const auto add = [&](std::optional<Finding> finding) {
    if (finding) diagnosis.faults.push_back(std::move(*finding));
  };
  if (geometry.is_known()) add(centre_outside(inertial, geometry));
  if (diagnosis.agreement) return;
  add(identity(diagnosis.body, geometry));
  if (geometry.is_known()) add(too_large(diagnosis.body, geometry));
  if (diagnosis.faults.empty()) add(too_small(diagnosis.body, geometry));
}

bool has_same_numbers(const Inertial& a, const Inertial& b) {
  return a.mass.value == b.mass.value &&
         std::ranges::equal(a.entries, b.entries, {}, &Written::value, &Written::value);
}

/// Finds a link whose geometry has the numbers of this one.
std::optional<Finding> copied(const Robot& robot, std::size_t index,
                              const std::vector<LinkGeometry>& geometries) {
  const Inertial& own = *robot.links[index].inertial;
  const double digits = relative_resolution(own);
  // The left and the right link of a robot may differ a little.
  constexpr double alike = 0.05;
  const bool is_alike = std::ranges::any_of(
      geometries[index].models(),
      [&](const MassModel& model) { return misfit_of(stated_mass(own), model) < alike; });
  if (is_alike || geometries[index].models().empty()) return std::nullopt;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const Link& other = robot.links[i];
    if (i == index || !other.inertial || !has_same_numbers(own, *other.inertial)) continue;
    const LinkMass body = stated_mass(*other.inertial);
    for (const MassModel& model : geometries[i].models()) {
      const double misfit = misfit_of(body, model);
      if (misfit > digits) continue;
      return Finding{Fault::copied,
                     fmt::format("they are the numbers of link '{}'", other.name),
                     {},
                     misfit,
                     fmt::format("{} ('{}')", model.source, other.name)};
    }
  }
  return std::nullopt;
}

Diagnosis judge(const Robot& robot, std::size_t index,
                const std::vector<LinkGeometry>& geometries) {
  const Link& link = robot.links[index];
  const LinkGeometry& geometry = geometries[index];
  Diagnosis diagnosis;
  if (!link.inertial) return diagnosis;
  diagnosis.body = stated_mass(*link.inertial);
  diagnosis.verdict = Verdict::good;
  if (is_finite(diagnosis.body)) diagnosis.moments = principal_moments(diagnosis.body.inertia);
  if (auto finding = impossibility(diagnosis.body)) {
    diagnosis.verdict = Verdict::impossible;
    diagnosis.faults.push_back(std::move(*finding));
    if (diagnosis.faults.front().fault == Fault::not_finite) return diagnosis;
  } else {
    diagnosis.agreement = agreement(*link.inertial, geometry.models());
    add_doubts(*link.inertial, geometry, diagnosis);
  }
  diagnosis.mistakes = mistakes(*link.inertial, geometry.models(), diagnosis);
  if (!diagnosis.agreement && diagnosis.mistakes.empty()) {
    if (auto finding = copied(robot, index, geometries))
      diagnosis.mistakes.push_back(std::move(*finding));
  }
  const bool is_doubtful = !diagnosis.faults.empty() || !diagnosis.mistakes.empty();
  if (diagnosis.verdict == Verdict::good && is_doubtful) diagnosis.verdict = Verdict::doubtful;
  return diagnosis;
}

/// Mass properties that a simulator computes from the geometry cannot be wrong.
Diagnosis diagnosis_of_geometry(const std::optional<LinkMass>& body) {
  Diagnosis diagnosis;
  if (!body || !(body->mass > 0.0)) return diagnosis;
  diagnosis.verdict = Verdict::good;
  diagnosis.body = *body;
  diagnosis.moments = principal_moments(body->inertia);
  diagnosis.agreement = Agreement{"its geometry, which defines them"};
  return diagnosis;
}

}  // namespace

LinkMass stated_mass(const Inertial& inertial) {
  return {inertial.mass.value, inertial.centre_of_mass(), inertial.inertia()};
}

Matrix3d second_moments(const Matrix3d& inertia) {
  return 0.5 * inertia.trace() * Matrix3d::Identity() - inertia;
}

Vector3d principal_moments(const Matrix3d& inertia) {
  return Eigen::SelfAdjointEigenSolver<Matrix3d>(inertia, Eigen::EigenvaluesOnly).eigenvalues();
}

bool is_possible(const LinkMass& body) { return !impossibility(body); }

JudgedRobot judge_robot(Robot robot, const std::vector<std::filesystem::path>& packages) {
  JudgedRobot judged;
  judged.robot = std::move(robot);
  judged.notes = judged.robot.notes;
  Meshes meshes(judged.robot, packages);
  for (const Link& link : judged.robot.links) {
    judged.geometries.emplace_back(link, meshes);
    for (const std::string& problem : judged.geometries.back().problems())
      judged.notes.push_back(fmt::format("{}:{}: link '{}': {}", judged.robot.file.string(),
                                         link.line, link.name, problem));
  }
  const std::vector<std::optional<LinkMass>> bodies = compiled(judged.robot, judged.geometries);
  for (std::size_t i = 0; i < judged.robot.links.size(); ++i) {
    judged.diagnoses.push_back(judged.robot.links[i].is_from_geometry
                                   ? diagnosis_of_geometry(bodies[i])
                                   : judge(judged.robot, i, judged.geometries));
  }
  judged.files = meshes.files();
  judged.files.insert(judged.files.end(), judged.robot.others.begin(), judged.robot.others.end());
  return judged;
}

}  // namespace twrench::robot

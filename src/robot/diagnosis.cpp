#include "robot/diagnosis.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <system_error>
#include <utility>

#include "base/words.h"
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

/// Numbers beyond this belong to no body, and would overflow in products.
constexpr double largest = 1e60;

/// Whether all numbers and their quotients are finite.
bool is_finite(const LinkMass& body) {
  const bool is_mass = body.mass == 0.0 || std::abs(body.mass) > 1 / largest;
  // Comparisons with NaN are false.
  return is_mass && std::abs(body.mass) < largest &&
         (body.centre.cwiseAbs().array() < largest).all() &&
         (body.inertia.cwiseAbs().array() < largest).all();
}

/// Half a unit of the last digit of the centre, in m. A coordinate that is written as "0" is exact.
double resolution_of_centre(const Inertial& inertial) {
  double resolution = 0.0;
  for (const Written& coordinate : inertial.centre)
    if (coordinate.value != 0.0) resolution = std::max(resolution, coordinate.resolution);
  return resolution;
}

std::string list_of(const Vector3d& v) {
  return fmt::format("{:.4g}, {:.4g} and {:.4g}", v[0], v[1], v[2]);
}

/// Returns what makes the mass properties impossible for any body.
std::optional<Finding> impossibility(const LinkMass& body) {
  if (!is_finite(body)) {
    return Finding{Fault::not_finite,
                   "a number is NaN, infinite, or too large or small for any body"};
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

/// How far the centre of mass may lie outside the geometry in m, because both are rounded. Few
/// digits need not mean a rough number: 0.1 is often exact.
double tolerance_of_centre(const Inertial& inertial, const LinkGeometry& geometry) {
  const double size = geometry.extent(Vector3d::UnitX()) + geometry.extent(-Vector3d::UnitX());
  return std::clamp(2 * resolution_of_centre(inertial), 1e-3 * size, 0.02 * size);
}

/// Returns a direction along which the mass would have to lie farther out than the geometry: the
/// variance of a distribution between a and b with the mean m is at most (b - m)(m - a) (Bhatia and
/// Davis, Am. Math. Mon. 107 (2000) 353).
std::optional<Finding> too_large(const LinkMass& body, const LinkGeometry& geometry,
                                 double tolerance_of_centre) {
  const Matrix3d second = second_moments(body.inertia) / body.mass;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(second);
  for (int i = 2; i >= 0; --i) {
    const Vector3d along = solver.eigenvectors().col(i);
    const double variance = solver.eigenvalues()[i];
    const double mean = body.centre.dot(along);
    const double ahead = geometry.extent(along) - mean + tolerance_of_centre;
    const double behind = mean + geometry.extent(-along) + tolerance_of_centre;
    const double most = ahead * behind;
    // A centre outside allows no moments. It is reported separately.
    if (variance <= 1.01 * most || ahead <= 0.0 || behind <= 0.0) continue;
    return Finding{Fault::too_large,
                   fmt::format("the mass would lie {:.3g} m from the centre of mass (root mean "
                               "square), but the geometry allows {:.3g} m",
                               std::sqrt(variance), std::sqrt(most))};
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
  if (distance <= tolerance_of_centre(inertial, geometry)) return std::nullopt;
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
  if (geometry.is_known())
    add(too_large(diagnosis.body, geometry, tolerance_of_centre(inertial, geometry)));
  if (diagnosis.faults.empty()) add(too_small(diagnosis.body, geometry));
}

using Numbers = std::array<double, 7>;

/// The mass and the entries of the matrix.
Numbers numbers_of(const Inertial& inertial) {
  Numbers numbers{inertial.mass.value};
  std::ranges::transform(inertial.entries, numbers.begin() + 1, &Written::value);
  return numbers;
}

bool states_inertia(const Link& link) { return link.inertial && !link.is_from_geometry; }

/// Whether a mistake may explain the numbers of a link, and none is known.
bool is_unexplained(const Link& link, const Diagnosis& diagnosis) {
  return states_inertia(link) && is_finite(diagnosis.body) && !diagnosis.agreement &&
         diagnosis.mistakes.empty();
}

/// Names the links that have the numbers of another link, whose geometry explains them.
void add_copies(JudgedRobot& judged) {
  std::map<Numbers, std::size_t> originals;
  for (std::size_t i = 0; i < judged.diagnoses.size(); ++i) {
    const Link& link = judged.robot.links[i];
    if (states_inertia(link) && judged.diagnoses[i].agreement)
      originals.emplace(numbers_of(*link.inertial), i);
  }
  // The left and the right link of a robot may differ a little.
  constexpr double alike = 0.05;
  for (std::size_t i = 0; i < judged.diagnoses.size(); ++i) {
    const Link& link = judged.robot.links[i];
    Diagnosis& diagnosis = judged.diagnoses[i];
    const std::vector<MassModel>& models = judged.geometries[i].models();
    if (!is_unexplained(link, diagnosis) || models.empty()) continue;
    const auto original = originals.find(numbers_of(*link.inertial));
    const bool is_alike = std::ranges::any_of(
        models, [&](const MassModel& model) { return misfit_of(diagnosis.body, model) < alike; });
    if (original == originals.end() || is_alike) continue;
    const std::string& name = judged.robot.links[original->second].name;
    const Agreement& agreement = *judged.diagnoses[original->second].agreement;
    diagnosis.mistakes.push_back({Fault::copied,
                                  fmt::format("they are the numbers of link '{}'", name),
                                  {},
                                  agreement.misfit,
                                  fmt::format("{} ('{}')", agreement.model, name)});
    diagnosis.verdict = std::max(diagnosis.verdict, Verdict::doubtful);
  }
}

Diagnosis judge(const Link& link, const LinkGeometry& geometry) {
  Diagnosis diagnosis;
  if (!link.inertial) return diagnosis;
  const LinkMass body = stated_mass(*link.inertial);
  // A frame, such as that of a tool: it adds nothing to the mass of the link to which it is fixed.
  if (link.is_fixed && body.mass == 0.0 && body.inertia.isZero(0.0)) return diagnosis;
  diagnosis.body = body;
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

/// Adds a note about the meshes that were not found, or two with different remedies.
void add_missing_meshes(const std::set<std::string>& missing, JudgedRobot& judged) {
  std::vector<std::string> in_packages, beside;
  for (const std::string& uri : missing) (is_in_package(uri) ? in_packages : beside).push_back(uri);
  const auto add = [&](const std::vector<std::string>& uris, const std::string& remedy) {
    if (uris.empty()) return;
    judged.notes.push_back(
        fmt::format("{}: {} not found: {}; {}", judged.robot.file.string(),
                    uris.size() == 1 ? "a mesh was" : fmt::format("{} meshes were", uris.size()),
                    list_of_names(uris), remedy));
  };
  add(in_packages,
      "name the folder that contains the packages: " + argument("package-path", "DIR"));
  add(beside, "paths are relative to the folder of the description");
}

/// Adds notes about the meshes that are not used as solids, one for each of the first problems.
void add_mesh_notes(const Meshes& meshes, JudgedRobot& judged) {
  add_missing_meshes(meshes.missing(), judged);
  const std::vector<Link>& links = judged.robot.links;
  std::map<std::string, std::vector<std::size_t>> problems;
  for (std::size_t i = 0; i < links.size(); ++i)
    for (const std::string& problem : judged.geometries[i].problems())
      problems[problem].push_back(i);
  constexpr std::size_t most = 5;
  std::size_t notes = 0;
  for (const auto& [problem, indices] : problems) {
    if (++notes > most) {
      judged.notes.push_back(fmt::format("{}: {} other meshes are not used as solids",
                                         judged.robot.file.string(), problems.size() - most));
      break;
    }
    std::vector<std::string> names;
    for (const std::size_t index : indices) names.push_back(links[index].name);
    judged.notes.push_back(fmt::format("{}:{}: link{} {}: {}", judged.robot.file.string(),
                                       links[indices.front()].line, names.size() > 1 ? "s" : "",
                                       list_of_names(names), problem));
  }
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
  for (const std::filesystem::path& folder : packages) {
    std::error_code ignored;
    if (std::filesystem::is_directory(folder, ignored)) continue;
    throw InvalidArgument(argument("package-path", folder.string()), "there is no such folder",
                          "name one that contains packages or models");
  }
  JudgedRobot judged;
  judged.robot = std::move(robot);
  judged.notes = judged.robot.notes;
  Meshes meshes(judged.robot, packages);
  for (const Link& link : judged.robot.links) judged.geometries.emplace_back(link, meshes);
  add_mesh_notes(meshes, judged);
  const std::vector<std::optional<LinkMass>> bodies = compiled(judged.robot, judged.geometries);
  for (std::size_t i = 0; i < judged.robot.links.size(); ++i) {
    judged.diagnoses.push_back(judged.robot.links[i].is_from_geometry
                                   ? diagnosis_of_geometry(bodies[i])
                                   : judge(judged.robot.links[i], judged.geometries[i]));
  }
  add_copies(judged);
  judged.files = meshes.files();
  judged.files.insert(judged.files.end(), judged.robot.others.begin(), judged.robot.others.end());
  return judged;
}

}  // namespace twrench::robot

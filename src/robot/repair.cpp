#include "robot/repair.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/words.h"

namespace twrench::robot {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The least second moment of a repaired body, relative to the sum of all. The digits that are
/// written must not make it negative.
constexpr double least_share = 1e-6;

/// A piece of the file and the bytes that replace it.
struct Edit {
  Span span;
  std::string text;
};

/// The new mass properties of a link, nothing if there are none, and the reason.
struct Plan {
  std::optional<LinkMass> body;
  std::string reason;
};

/// `scale` is the size of the greatest number of its kind, beside which round-off is 0.
std::string digits(double value, double scale) {
  constexpr double round_off = 1e-12;
  return fmt::format("{:.12g}", std::abs(value) < round_off * scale ? 0.0 : value);
}

/// Whether a number needs to be written: it differs from the one in the file by more than its last
/// digit.
bool differs(double a, double b, double scale) { return std::abs(a - b) > 1e-11 * scale; }

/// Adds the edit of a number, if it changes. Returns false if the file has no place for it.
bool add_edit(const Written& written, double value, double scale, std::vector<Edit>& edits) {
  if (!differs(written.value, value, scale)) return true;
  if (!written.place) return false;
  edits.push_back({*written.place, digits(value, scale)});
  return true;
}

/// An attribute `diaginertia` becomes `fullinertia` in the axes of the link, without a rotation.
void add_full_matrix(const Inertial& inertial, const Matrix3d& inertia, std::vector<Edit>& edits) {
  const double scale = inertia.cwiseAbs().maxCoeff();
  std::string text = " fullinertia=\"";
  for (std::size_t i = 0; i < entry_indices.size(); ++i) {
    const auto [row, column] = entry_indices[i];
    text += (i == 0 ? "" : " ") + digits(inertia(row, column), scale);
  }
  edits.push_back({*inertial.diagonal, text + "\""});
  for (const Span& rotation : inertial.rotations) edits.push_back({rotation, ""});
}

/// Returns the edits that give a link other mass properties; nothing if the file has no place for
/// one of the numbers.
std::optional<std::vector<Edit>> edits_for(const Inertial& inertial, const LinkMass& body) {
  std::vector<Edit> edits;
  if (!add_edit(inertial.mass, body.mass, body.mass, edits)) return std::nullopt;
  for (int i = 0; i < 3; ++i) {
    if (!add_edit(inertial.centre[i], body.centre[i], 1.0, edits)) return std::nullopt;
  }
  const Matrix3d& rotation = inertial.link_from_inertial;
  const Matrix3d stated = inertial.matrix(),
                 matrix = rotation.transpose() * body.inertia * rotation;
  const double scale = matrix.cwiseAbs().maxCoeff();
  if (inertial.diagonal) {
    if (!(stated - matrix).isZero(1e-11 * scale)) add_full_matrix(inertial, body.inertia, edits);
    return edits;
  }
  for (std::size_t i = 0; i < inertial.entries.size(); ++i) {
    const auto [row, column] = entry_indices[i];
    if (!add_edit(inertial.entries[i], matrix(row, column), scale, edits)) return std::nullopt;
  }
  return edits;
}

std::string with_edits(std::string_view text, std::vector<Edit> edits) {
  std::ranges::sort(edits, {}, [](const Edit& edit) { return edit.span.begin; });
  std::string result;
  std::size_t done = 0;
  for (const Edit& edit : edits) {
    result.append(text.substr(done, edit.span.begin - done)).append(edit.text);
    done = edit.span.end();
  }
  return result.append(text.substr(done));
}

/// Whether all mistakes lead to the same mass properties.
bool agree(const std::vector<Finding>& mistakes) {
  const auto& first = mistakes.front().undone;
  return std::ranges::all_of(mistakes, [&](const Finding& mistake) {
    return first && mistake.undone && mistake.undone->mass == first->mass &&
           mistake.undone->inertia.isApprox(first->inertia, 1e-3);
  });
}

/// The centre and the moments of a geometry, with the link's mass or, if it has none, that of the
/// geometry.
std::optional<LinkMass> of_geometry(const LinkMass& stated, const LinkGeometry& geometry) {
  if (geometry.models().empty()) return std::nullopt;
  const MassModel& model = geometry.models().front();
  const double mass = stated.mass > 0.0 ? stated.mass : model.mass.value_or(0.0);
  const LinkMass body{mass, model.body.centre, mass * model.body.inertia};
  return is_possible(body) ? std::optional(body) : std::nullopt;
}

Plan plan_for(const Diagnosis& diagnosis, const LinkGeometry& geometry, bool from_geometry) {
  const bool is_explained = !diagnosis.mistakes.empty() && diagnosis.mistakes.front().misfit &&
                            diagnosis.mistakes.front().undone;
  if (is_explained && agree(diagnosis.mistakes)) {
    const Finding& mistake = diagnosis.mistakes.front();
    if (is_possible(*mistake.undone)) return {mistake.undone, mistake.text};
  }
  const std::string fault =
      (diagnosis.faults.empty() ? diagnosis.mistakes : diagnosis.faults).front().text;
  if (from_geometry) {
    const auto body = of_geometry(diagnosis.body, geometry);
    if (body) return {body, fault + "; replaced by the geometry with uniform density"};
    return {{}, fault + "; the geometry or the mass is not known"};
  }
  if (is_explained) return {{}, "several mistakes explain it equally well"};
  if (diagnosis.verdict != Verdict::impossible) {
    return {{}, fault + "; " + argument("from-mesh") + " takes the geometry's moments"};
  }
  const LinkMass& stated = diagnosis.body;
  const bool is_number = diagnosis.faults.front().fault != Fault::not_finite;
  if (is_number && stated.mass > 0.0 && second_moments(stated.inertia).trace() > 0.0) {
    return {nearest_possible(stated), fault + "; replaced by the nearest possible moments"};
  }
  return {{}, fault + "; " + argument("from-mesh") + " takes the geometry's moments"};
}

}  // namespace

LinkMass nearest_possible(const LinkMass& body) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(second_moments(body.inertia));
  const double sum = solver.eigenvalues().cwiseMax(0.0).sum();
  const Vector3d second = solver.eigenvalues().cwiseMax(least_share * sum);
  const Matrix3d& axes = solver.eigenvectors();
  LinkMass result = body;
  result.inertia =
      second.sum() * Matrix3d::Identity() - axes * second.asDiagonal() * axes.transpose();
  return result;
}

Repair repair(const JudgedRobot& judged, bool from_geometry) {
  const Robot& robot = judged.robot;
  Repair result;
  std::vector<Edit> edits;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const Diagnosis& diagnosis = judged.diagnoses[i];
    if (!diagnosis.is_bad()) continue;
    const Plan plan = plan_for(diagnosis, judged.geometries[i], from_geometry);
    if (!plan.body) {
      result.unrepaired.push_back({robot.links[i].name, plan.reason});
      continue;
    }
    const auto own = edits_for(*robot.links[i].inertial, *plan.body);
    if (!own) {
      result.unrepaired.push_back(
          {robot.links[i].name, plan.reason + "; the file has no place for one of the numbers"});
      continue;
    }
    edits.insert(edits.end(), own->begin(), own->end());
    result.changes.push_back({i, robot.links[i].name, plan.reason, diagnosis.body, *plan.body});
  }
  result.text = with_edits(robot.text, std::move(edits));
  return result;
}

}  // namespace twrench::robot

#include <algorithm>
#include <cmath>

#include "base/require.h"
#include "body/shape_functions.h"

namespace twrench::body::shapes {

using Eigen::Vector3d;

std::string name(const Mesh&) { return "mesh"; }

std::vector<Dimension> dimensions(Mesh& m) { return {length_or_zero("shell", m.shell)}; }

void check(const Mesh& m) {
  if (!m.surface || m.surface->vertices.empty()) throw InvalidArgument("mesh", "has no surface");
  require_positive("mesh", m.integrals.volume);
}

double volume(const Mesh& m) { return m.integrals.volume; }

Vector3d centroid(const Mesh& m) { return m.integrals.centroid; }

Eigen::Matrix3d central_inertia(const Mesh& m, double mass) {
  return mass / m.integrals.volume * m.integrals.inertia;
}

Vector3d support(const Mesh& m, const Vector3d& direction) {
  return *std::ranges::max_element(m.surface->vertices, {},
                                   [&](const Vector3d& vertex) { return direction.dot(vertex); });
}

double far_side(const Mesh& m, const Vector3d& from) {
  double squared = 0.0;
  for (const Vector3d& vertex : m.surface->vertices) {
    squared = std::max(squared, (vertex - from).squaredNorm());
  }
  return std::sqrt(squared);
}

}  // namespace twrench::body::shapes

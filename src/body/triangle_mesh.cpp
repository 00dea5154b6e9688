#include <fmt/format.h>
#include <twrench/body/shape.h>
#include <twrench/body/triangle_mesh.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/parallel.h"
#include "base/require.h"
#include "body/double_double.h"

namespace twrench::body {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

using Triangle = std::array<std::uint32_t, 3>;
/// Number of triangles that a thread sums at a time.
constexpr std::size_t grain = 8192;

using ExactVector = std::array<DoubleDouble, 3>;

// The six independent components of a symmetric matrix.
constexpr std::array<std::pair<std::size_t, std::size_t>, 6> components{
    {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};

/// The corners of a triangle relative to a point from which their differences are exact.
using Corners = std::array<std::array<double, 3>, 3>;

/// Sums over triangles with corners a, b, c of a weight w, of w s with s = a + b + c, and of w
/// times a a' + b b' + c c' + s s'. In double precision the terms of thin, hollow or distant bodies
/// would cancel to a few digits. In this precision the result is as good as with exact arithmetic.
struct Sums {
  DoubleDouble weight;
  ExactVector first;
  std::array<DoubleDouble, 6> second;

  void add(const Corners& corners, const DoubleDouble& w) {
    const auto& [a, b, c] = corners;
    ExactVector s;
    for (std::size_t i = 0; i < 3; ++i) s[i] = exact_sum(a[i], b[i]) + DoubleDouble{c[i]};
    weight = weight + w;
    for (std::size_t i = 0; i < 3; ++i) first[i] = first[i] + w * s[i];
    for (std::size_t n = 0; n < components.size(); ++n) {
      const auto [i, j] = components[n];
      const DoubleDouble products = (exact_product(a[i], a[j]) + exact_product(b[i], b[j])) +
                                    (exact_product(c[i], c[j]) + s[i] * s[j]);
      second[n] = second[n] + w * products;
    }
  }

  void add(const Sums& other) {
    weight = weight + other.weight;
    for (std::size_t i = 0; i < 3; ++i) first[i] = first[i] + other.first[i];
    for (std::size_t n = 0; n < 6; ++n) second[n] = second[n] + other.second[n];
  }
};

ExactVector cross(const ExactVector& a, const ExactVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

ExactVector difference(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return {exact_sum(a[0], -b[0]), exact_sum(a[1], -b[1]), exact_sum(a[2], -b[2])};
}

/// Returns six times the signed volume of the tetrahedron of the corners and the origin.
DoubleDouble six_volumes(const Corners& corners) {
  const auto &a = corners[0], &b = corners[1], &c = corners[2];
  const auto minor = [&](std::size_t i, std::size_t j) {
    return exact_product(b[i], c[j]) - exact_product(b[j], c[i]);
  };
  return minor(1, 2) * a[0] + minor(2, 0) * a[1] + minor(0, 1) * a[2];
}

/// Returns twice the area in double precision, which suffices for sums of positive terms.
double two_areas(const Corners& corners) {
  const auto& [a, b, c] = corners;
  const ExactVector normal = cross(difference(b, a), difference(c, a));
  return Vector3d(normal[0].high, normal[1].high, normal[2].high).norm();
}

/// Throws InvalidArgument unless there are triangles and all their corners are finite points.
void check(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw InvalidArgument("mesh", "has no triangles");
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (mesh.vertices[i].allFinite()) continue;
    throw InvalidArgument("mesh", fmt::format("vertex {} is not finite", i));
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::uint32_t greatest = std::ranges::max(mesh.triangles[i]);
    if (greatest < mesh.vertices.size()) continue;
    throw InvalidArgument("mesh", fmt::format("triangle {} refers to vertex {}, but there are {}",
                                              i, greatest, mesh.vertices.size()));
  }
}

/// Returns the point to which all corners are referred, chosen so that no difference is rounded. In
/// each coordinate it is the first vertex if all values lie within a factor of two, because their
/// differences are then exact (Sterbenz), and otherwise 0. No corner is farther from it than twice
/// the size of the mesh.
Vector3d reference_point(const TriangleMesh& mesh) {
  Vector3d least = mesh.vertices[mesh.triangles[0][0]], greatest = least;
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      least = least.cwiseMin(mesh.vertices[corner]);
      greatest = greatest.cwiseMax(mesh.vertices[corner]);
    }
  }
  Vector3d reference = Vector3d::Zero();
  for (Eigen::Index i = 0; i < 3; ++i) {
    const bool is_distant = (least[i] > 0.0 && greatest[i] / 2.0 <= least[i]) ||
                            (greatest[i] < 0.0 && least[i] / 2.0 >= greatest[i]);
    if (is_distant) reference[i] = least[i];
  }
  return reference;
}

Corners corners_of(const TriangleMesh& mesh, const Triangle& triangle, const Vector3d& reference) {
  Corners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3d difference = mesh.vertices[triangle[k]] - reference;
    corners[k] = {difference.x(), difference.y(), difference.z()};
  }
  return corners;
}

/// Returns the sums over all triangles, the same on any number of threads.
template <typename Weight>
Sums sums_over(const TriangleMesh& mesh, const Vector3d& reference, Weight weight) {
  std::vector<Sums> parts((mesh.triangles.size() + grain - 1) / grain);
  for_each_part(mesh.triangles.size(), grain, 0, [&](std::size_t begin, std::size_t end) {
    Sums& sums = parts[begin / grain];
    for (std::size_t i = begin; i < end; ++i) {
      const Corners corners = corners_of(mesh, mesh.triangles[i], reference);
      sums.add(corners, weight(corners));
    }
  });
  Sums all;
  for (const Sums& part : parts) all.add(part);
  return all;
}

/// Returns the integrals. The sums divided by `divisors` are the volume and the first and second
/// moments about the reference point.
SolidIntegrals integrals_of(const Sums& sums, const Vector3d& reference,
                            const std::array<double, 3>& divisors) {
  const DoubleDouble volume = sums.weight / DoubleDouble{divisors[0]};
  SolidIntegrals result;
  result.volume = volume.high;
  ExactVector mean;
  for (std::size_t i = 0; i < 3; ++i) {
    mean[i] = sums.first[i] / (volume * divisors[1]);
    const auto index = static_cast<Eigen::Index>(i);
    result.centroid[index] =
        (exact_sum(reference[index], mean[i].high) + DoubleDouble{mean[i].low}).high;
  }
  std::array<DoubleDouble, 6> central;
  for (std::size_t n = 0; n < components.size(); ++n) {
    const auto [i, j] = components[n];
    central[n] = sums.second[n] / DoubleDouble{divisors[2]} - volume * (mean[i] * mean[j]);
  }
  const double xx = (central[1] + central[2]).high, yy = (central[0] + central[2]).high,
               zz = (central[0] + central[1]).high;
  const double yz = -central[3].high, xz = -central[4].high, xy = -central[5].high;
  result.inertia << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return result;
}

/// Returns the integrals, or throws InvalidArgument about "mesh" if they exceed the range of a
/// double.
const SolidIntegrals& finite(const SolidIntegrals& integrals) {
  const bool is_finite = std::isfinite(integrals.volume) && integrals.centroid.allFinite() &&
                         integrals.inertia.allFinite();
  if (is_finite) return integrals;
  throw InvalidArgument("mesh", "its integrals are beyond what double precision holds");
}

}  // namespace

SolidIntegrals solid_integrals(const TriangleMesh& mesh) {
  check(mesh);
  const Vector3d reference = reference_point(mesh);
  // Integrals over the tetrahedra on the triangles, with the reference point as the fourth corner.
  const Sums sums = sums_over(mesh, reference, six_volumes);
  if (sums.weight.high <= 0.0) {
    throw InvalidArgument(
        "mesh", fmt::format("its volume is {:.6g} cm^3", sums.weight.high / 6.0),
        "close it, and let its triangles run counter-clockwise seen from outside");
  }
  return finite(integrals_of(sums, reference, {6.0, 24.0, 120.0}));
}

SolidIntegrals shell_integrals(const TriangleMesh& mesh, double thickness) {
  require_positive("thickness", thickness);
  check(mesh);
  const Vector3d reference = reference_point(mesh);
  const Sums sums = sums_over(
      mesh, reference, [](const Corners& corners) { return DoubleDouble{two_areas(corners)}; });
  if (sums.weight.high == 0.0) throw InvalidArgument("mesh", "its area is 0");
  SolidIntegrals wall = integrals_of(sums, reference, {2.0, 6.0, 24.0});
  wall.volume *= thickness;
  wall.inertia *= thickness;
  return finite(wall);
}

double surface_area(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return 0.0;
  check(mesh);
  std::vector<DoubleDouble> parts((mesh.triangles.size() + grain - 1) / grain);
  for_each_part(mesh.triangles.size(), grain, 0, [&](std::size_t begin, std::size_t end) {
    DoubleDouble& sum = parts[begin / grain];
    for (std::size_t i = begin; i < end; ++i) {
      const Corners corners = corners_of(mesh, mesh.triangles[i], Vector3d::Zero());
      sum = sum + DoubleDouble{two_areas(corners)};
    }
  });
  DoubleDouble all;
  for (const DoubleDouble& part : parts) all = all + part;
  return all.high / 2.0;
}

Mesh make_mesh(TriangleMesh surface, double shell) {
  const SolidIntegrals integrals =
      shell == 0.0 ? solid_integrals(surface) : shell_integrals(surface, shell);
  return {std::make_shared<const TriangleMesh>(std::move(surface)), shell, integrals};
}

}  // namespace twrench::body

#include "picture/body/lumps.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "picture/body/mesh.h"

namespace twrench::picture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr std::size_t lump_count = 8;

/// A point of a surface, in body axes, cm.
struct SurfaceSample {
  Vector3d position;
  Vector3d normal;  ///< Outward unit normal; 0 on a wall, which has no inside.
};

struct SurfaceTriangle {
  Vector3d a, b, c;

  /// Along the normal, with the area as its length.
  Vector3d area() const { return (b - a).cross(c - a) / 2; }
};

std::vector<SurfaceTriangle> triangles_of(const body::Part& part) {
  std::vector<SurfaceTriangle> result;
  if (const auto* const mesh = std::get_if<body::Mesh>(&part.shape)) {
    const auto place = [&](std::uint32_t i) -> Vector3d {
      return part.position + part.body_from_part * mesh->surface->vertices[i];
    };
    for (const auto& [a, b, c] : mesh->surface->triangles) {
      result.push_back({place(a), place(b), place(c)});
    }
    return result;
  }
  constexpr double coarse = 0.01;
  const Mesh surface = part_mesh(part, coarse * body::bounding_radius(part.shape));
  const auto place = [&](std::size_t i) {
    const glm::vec3& p = surface.vertices[surface.indices[i]].position;
    return Vector3d(p.x, p.y, p.z);
  };
  for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
    result.push_back({place(i), place(i + 1), place(i + 2)});
  }
  return result;
}

/// Points spread evenly over triangles, in each by a sequence of low discrepancy (Roberts, "The
/// Unreasonable Effectiveness of Quasirandom Sequences", 2018).
std::vector<SurfaceSample> samples_of(std::span<const SurfaceTriangle> triangles, bool is_wall) {
  constexpr double count = 2000;
  double whole = 0;
  for (const SurfaceTriangle& triangle : triangles) whole += triangle.area().norm();
  std::vector<SurfaceSample> samples;
  double due = 0.5;
  for (const SurfaceTriangle& triangle : triangles) {
    const Vector3d area = triangle.area();
    for (due += count * area.norm() / whole; due >= 1; --due) {
      const auto number = static_cast<double>(samples.size());
      double s = std::fmod(0.7548776662466927 * number, 1.0);
      double t = std::fmod(0.5698402909980532 * number, 1.0);
      if (s + t > 1) s = 1 - s, t = 1 - t;
      const auto& [a, b, c] = triangle;
      samples.push_back(
          {a + s * (b - a) + t * (c - a), is_wall ? Vector3d::Zero() : area.normalized()});
    }
  }
  return samples;
}

std::size_t nearest(std::span<const Vector3d> centres, const Vector3d& point) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < centres.size(); ++i) {
    if ((centres[i] - point).squaredNorm() < (centres[best] - point).squaredNorm()) best = i;
  }
  return best;
}

/// Returns the first sample and then, repeatedly, the one that is farthest from all before.
std::vector<Vector3d> first_centres(std::span<const SurfaceSample> samples) {
  std::vector<Vector3d> centres{samples.front().position};
  while (centres.size() < lump_count) {
    const auto distance = [&](const SurfaceSample& sample) {
      return (centres[nearest(centres, sample.position)] - sample.position).squaredNorm();
    };
    centres.push_back(std::ranges::max_element(samples, {}, distance)->position);
  }
  return centres;
}

using Pieces = std::vector<std::vector<SurfaceSample>>;

Pieces pieces_of(std::span<const SurfaceSample> samples) {
  std::vector<Vector3d> centres = first_centres(samples);
  Pieces pieces;
  constexpr int turns = 12;
  for (int turn = 0; turn < turns; ++turn) {
    pieces.assign(lump_count, {});
    for (const SurfaceSample& sample : samples) {
      pieces[nearest(centres, sample.position)].push_back(sample);
    }
    for (std::size_t i = 0; i < lump_count; ++i) {
      if (pieces[i].empty()) continue;
      Vector3d sum = Vector3d::Zero();
      for (const SurfaceSample& sample : pieces[i]) sum += sample.position;
      centres[i] = sum / static_cast<double>(pieces[i].size());
    }
  }
  return pieces;
}

/// Returns a capsule along the piece's longest principal axis, from the half sizes of a box about
/// the piece along these axes.
Capsule capsule_about(std::span<const SurfaceSample> piece) {
  Vector3d middle = Vector3d::Zero(), normal = Vector3d::Zero();
  for (const SurfaceSample& sample : piece) middle += sample.position, normal += sample.normal;
  middle /= static_cast<double>(piece.size());
  normal /= static_cast<double>(piece.size());
  Matrix3d squares = Matrix3d::Zero();
  for (const SurfaceSample& sample : piece) {
    squares += (sample.position - middle) * (sample.position - middle).transpose();
  }
  const Matrix3d axes = Eigen::SelfAdjointEigenSolver<Matrix3d>(squares).eigenvectors();
  Vector3d half = Vector3d::Zero();  // ascending
  for (const SurfaceSample& sample : piece) {
    half = half.cwiseMax((axes.transpose() * (sample.position - middle)).cwiseAbs());
  }
  const double radius = (half[0] + half[1]) / 2;
  const bool is_wall = piece.front().normal.isZero();
  const bool is_of_plate = !is_wall && radius * (1 - normal.norm()) > 2 * half[0];
  const Vector3d along = std::max(0.0, half[2] - radius / 2) * axes.col(2);
  middle -= radius * normal;
  return {
      .from = middle - along, .to = middle + along, .radius = radius, .is_of_plate = is_of_plate};
}

}  // namespace

std::vector<Capsule> lumps(const body::Part& part) {
  const auto* const mesh = std::get_if<body::Mesh>(&part.shape);
  const std::vector<SurfaceSample> samples =
      samples_of(triangles_of(part), mesh != nullptr && mesh->shell > 0);
  std::vector<Capsule> result;
  for (const auto& piece : pieces_of(samples)) {
    if (piece.size() > 2) result.push_back(capsule_about(piece));
  }
  return result;
}

}  // namespace twrench::picture

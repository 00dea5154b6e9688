#include <twrench/base/require.h>
#include <twrench/body/shape.h>
#include <twrench/body/triangle_mesh.h>

#include <Eigen/Geometry>
#include <utility>

namespace twrench::body {

using Eigen::Matrix3d;
using Eigen::Vector3d;

SolidIntegrals solid_integrals(const TriangleMesh& mesh) {
  SolidIntegrals result;
  Matrix3d second = Matrix3d::Zero();
  for (const auto& t : mesh.triangles) {
    const Vector3d &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const double six_volumes = a.dot(b.cross(c));
    const Vector3d sum = a + b + c;
    result.volume += six_volumes / 6;
    result.centroid += six_volumes / 24 * sum;
    second += six_volumes / 120 *
              (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  result.centroid /= result.volume;
  second -= result.volume * result.centroid * result.centroid.transpose();
  result.inertia = second.trace() * Matrix3d::Identity() - second;
  return result;
}

SolidIntegrals shell_integrals(const TriangleMesh& mesh, double thickness) {
  SolidIntegrals result;
  Matrix3d second = Matrix3d::Zero();
  for (const auto& t : mesh.triangles) {
    const Vector3d &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const double volume = thickness * (b - a).cross(c - a).norm() / 2;
    const Vector3d sum = a + b + c;
    result.volume += volume;
    result.centroid += volume / 3 * sum;
    second += volume / 12 *
              (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  result.centroid /= result.volume;
  second -= result.volume * result.centroid * result.centroid.transpose();
  result.inertia = second.trace() * Matrix3d::Identity() - second;
  return result;
}

double surface_area(const TriangleMesh& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles) {
    const Vector3d& a = mesh.vertices[t[0]];
    area += (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm() / 2;
  }
  return area;
}

Mesh make_mesh(TriangleMesh surface, double shell) {
  const SolidIntegrals integrals =
      shell > 0 ? shell_integrals(surface, shell) : solid_integrals(surface);
  return {std::make_shared<const TriangleMesh>(std::move(surface)), shell, integrals};
}

}  // namespace twrench::body

#include "picture/body/outline_radii.h"

#include "picture/body/occluders.h"

namespace twrench::picture {
namespace {

struct RadiiOf {
  OutlineRadii operator()(const body::Cylinder& c) const { return {c.radius, 0}; }
  OutlineRadii operator()(const body::Tube& t) const { return {t.radius, 0}; }
  OutlineRadii operator()(const body::Cone& c) const { return {(c.radius + c.top_radius) / 2, 0}; }
  OutlineRadii operator()(const body::Capsule& c) const { return {c.radius, c.radius}; }
  OutlineRadii operator()(const body::Torus& t) const { return {t.tube_radius, t.tube_radius}; }
  OutlineRadii operator()(const body::Ellipsoid& e) const {
    const double radius = mean_radius(e);
    return {radius, radius};
  }
  OutlineRadii operator()(const auto& shape) const { return {mean_radius(shape), 0}; }

  static double mean_radius(const body::Shape& shape) {
    return capsule_of({shape, 1, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Identity()}).radius;
  }
};

}  // namespace

OutlineRadii outline_radii(const body::Shape& shape) { return std::visit(RadiiOf(), shape); }

}  // namespace twrench::picture

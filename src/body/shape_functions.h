#pragma once

#include <twrench/body/shape.h>

#include <Eigen/Core>
#include <concepts>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "body/dimensions.h"

// The functions of each shape, defined in one source per shape in body/shapes. Points and
// directions are in the frame of the shape, lengths in cm. They have a separate namespace so that,
// if the function of a shape is missing, the compiler does not call that of the variant Shape
// instead.
//
// name             its name in scene files
// dimensions       views of its members
// check            throws OutOfRange or InvalidArgument unless it is a solid
// volume           cm^3
// centroid         the centre of mass
// central_inertia  about the centroid in g cm^2, for `mass` grams
// support          a point farthest along a unit vector
// far_side         the distance from a point to the farthest point of the shape, or an upper bound
//                  of it for an ellipsoid

namespace twrench::body {

/// Throws OutOfRange or InvalidArgument unless the part is a valid solid with a valid density and
/// position and a proper rotation.
void require_part(const Part& part);

}  // namespace twrench::body

namespace twrench::body::shapes {

std::string name(const Cylinder&);
std::vector<Dimension> dimensions(Cylinder&);
void check(const Cylinder&);
double volume(const Cylinder&);
Eigen::Vector3d centroid(const Cylinder&);
Eigen::Matrix3d central_inertia(const Cylinder&, double mass);
Eigen::Vector3d support(const Cylinder&, const Eigen::Vector3d& direction);
double far_side(const Cylinder&, const Eigen::Vector3d& from);

std::string name(const Box&);
std::vector<Dimension> dimensions(Box&);
void check(const Box&);
double volume(const Box&);
Eigen::Vector3d centroid(const Box&);
Eigen::Matrix3d central_inertia(const Box&, double mass);
Eigen::Vector3d support(const Box&, const Eigen::Vector3d& direction);
double far_side(const Box&, const Eigen::Vector3d& from);

std::string name(const Ellipsoid&);
std::vector<Dimension> dimensions(Ellipsoid&);
void check(const Ellipsoid&);
double volume(const Ellipsoid&);
Eigen::Vector3d centroid(const Ellipsoid&);
Eigen::Matrix3d central_inertia(const Ellipsoid&, double mass);
Eigen::Vector3d support(const Ellipsoid&, const Eigen::Vector3d& direction);
double far_side(const Ellipsoid&, const Eigen::Vector3d& from);

std::string name(const Cone&);
std::vector<Dimension> dimensions(Cone&);
void check(const Cone&);
double volume(const Cone&);
Eigen::Vector3d centroid(const Cone&);
Eigen::Matrix3d central_inertia(const Cone&, double mass);
Eigen::Vector3d support(const Cone&, const Eigen::Vector3d& direction);
double far_side(const Cone&, const Eigen::Vector3d& from);

std::string name(const Torus&);
std::vector<Dimension> dimensions(Torus&);
void check(const Torus&);
double volume(const Torus&);
Eigen::Vector3d centroid(const Torus&);
Eigen::Matrix3d central_inertia(const Torus&, double mass);
Eigen::Vector3d support(const Torus&, const Eigen::Vector3d& direction);
double far_side(const Torus&, const Eigen::Vector3d& from);

std::string name(const Capsule&);
std::vector<Dimension> dimensions(Capsule&);
void check(const Capsule&);
double volume(const Capsule&);
Eigen::Vector3d centroid(const Capsule&);
Eigen::Matrix3d central_inertia(const Capsule&, double mass);
Eigen::Vector3d support(const Capsule&, const Eigen::Vector3d& direction);
double far_side(const Capsule&, const Eigen::Vector3d& from);

std::string name(const Tube&);
std::vector<Dimension> dimensions(Tube&);
void check(const Tube&);
double volume(const Tube&);
Eigen::Vector3d centroid(const Tube&);
Eigen::Matrix3d central_inertia(const Tube&, double mass);
Eigen::Vector3d support(const Tube&, const Eigen::Vector3d& direction);
double far_side(const Tube&, const Eigen::Vector3d& from);

std::string name(const Mesh&);
std::vector<Dimension> dimensions(Mesh&);
void check(const Mesh&);
double volume(const Mesh&);
Eigen::Vector3d centroid(const Mesh&);
Eigen::Matrix3d central_inertia(const Mesh&, double mass);
Eigen::Vector3d support(const Mesh&, const Eigen::Vector3d& direction);
double far_side(const Mesh&, const Eigen::Vector3d& from);

template <class Solid>
concept IsComplete = requires(const Solid& solid, Solid& variable, double mass,
                              const Eigen::Vector3d& vector) {
  { shapes::name(solid) } -> std::same_as<std::string>;
  { shapes::dimensions(variable) } -> std::same_as<std::vector<Dimension>>;
  { shapes::check(solid) } -> std::same_as<void>;
  { shapes::volume(solid) } -> std::same_as<double>;
  { shapes::centroid(solid) } -> std::same_as<Eigen::Vector3d>;
  { shapes::central_inertia(solid, mass) } -> std::same_as<Eigen::Matrix3d>;
  { shapes::support(solid, vector) } -> std::same_as<Eigen::Vector3d>;
  { shapes::far_side(solid, vector) } -> std::same_as<double>;
};

template <class... Solid>
constexpr bool are_complete(std::type_identity<std::variant<Solid...>>) {
  return (IsComplete<Solid> && ...);
}
static_assert(are_complete(std::type_identity<Shape>()));

}  // namespace twrench::body::shapes

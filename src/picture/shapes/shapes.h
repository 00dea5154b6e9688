#pragma once

#include <twrench/body/shape.h>

#include <Eigen/Core>
#include <concepts>
#include <optional>
#include <type_traits>
#include <variant>

#include "picture/shapes/rings.h"

// The appearance of each shape. This folder has one source per shape. Points and directions are in
// the frame of the shape, lengths in cm.

namespace twrench::picture {

/// How a shape curves near its silhouette, which determines the reflections there. If the radii
/// vary, these are means.
struct OutlineRadii {
  /// Radius of curvature.
  double radius;
  /// The same for a shape with a round outline, else 0.
  double round;
};

/// A capsule about one of the shape's own axes, with its middle in the origin.
struct AxisCapsule {
  Eigen::Index axis;
  double half_length;
  double radius;
};

/// The middle of a wall: the side of a cylinder about the z axis, centred at the origin. For a
/// shape without a hole, the origin.
struct Middle {
  double radius;
  double half_length;
};

/// The properties of a shape on which its pictures depend.
struct ShapeTraits {
  OutlineRadii outline;
  /// A capsule that approximates the shape for soft shading. Nothing for a shape with hollows,
  /// which may be thin anywhere; lumps() returns several capsules for it.
  std::optional<AxisCapsule> occluder;
  /// Whether the shader can find the seam where another part enters its side.
  bool has_round_side;
  /// Whether it is foil, such as print, on another part.
  bool is_foil = false;
  Middle middle;
  /// A diagonal tensor with the symmetry of the shape under rotations by small angles.
  Eigen::Vector3d symmetry;
  /// The directions from the centre of mass to the ends of the shape, as columns. The opposite
  /// directions lead to ends, too.
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> ends;
};

/// The symmetry of solids of revolution, about their own z axis.
inline const Eigen::Vector3d of_revolution{1, 1, 0};
/// The symmetry of shapes that no rotation by a small angle maps to themselves.
inline const Eigen::Vector3d asymmetric{1, 2, 3};

/// Returns the capsule for a shape that fills about as much as a box with these half sizes. It is
/// along the longest axis, with ends inset by half a radius.
AxisCapsule capsule_in_box(const Eigen::Vector3d& half_sizes);

ShapeTraits traits_of(const body::Shape& shape);

// The functions of each shape:
//
// traits    its traits
// holds     whether a point lies in the shape grown by `margin` on all sides; false for a mesh, to
//           which no cylinder is joined
// rings_of  its surface, exact except for bevels, see part_mesh(); a mesh has its own triangles

ShapeTraits traits(const body::Cylinder&);
bool holds(const body::Cylinder&, const Eigen::Vector3d& point, double margin);
Rings rings_of(const body::Cylinder&, double tolerance);

ShapeTraits traits(const body::Box&);
bool holds(const body::Box&, const Eigen::Vector3d& point, double margin);
Rings rings_of(const body::Box&, double tolerance);

ShapeTraits traits(const body::Ellipsoid&);
bool holds(const body::Ellipsoid&, const Eigen::Vector3d& point, double margin);
Rings rings_of(const body::Ellipsoid&, double tolerance);

ShapeTraits traits(const body::Cone&);
bool holds(const body::Cone&, const Eigen::Vector3d& point, double margin);
Rings rings_of(const body::Cone&, double tolerance);

ShapeTraits traits(const body::Torus&);
bool holds(const body::Torus&, const Eigen::Vector3d& point, double margin);
Rings rings_of(const body::Torus&, double tolerance);

ShapeTraits traits(const body::Capsule&);
bool holds(const body::Capsule&, const Eigen::Vector3d& point, double margin);
Rings rings_of(const body::Capsule&, double tolerance);

ShapeTraits traits(const body::Tube&);
bool holds(const body::Tube&, const Eigen::Vector3d& point, double margin);
Rings rings_of(const body::Tube&, double tolerance);

ShapeTraits traits(const body::Mesh&);
bool holds(const body::Mesh&, const Eigen::Vector3d& point, double margin);

template <class Solid>
concept IsRings = requires(const Solid& solid) {
  { rings_of(solid, 0.0) } -> std::same_as<Rings>;
};

template <class Solid>
concept IsDrawn = requires(const Solid& solid, const Eigen::Vector3d& point) {
  { traits(solid) } -> std::same_as<ShapeTraits>;
  { holds(solid, point, 0.0) } -> std::same_as<bool>;
}
&&(IsRings<Solid> || std::same_as<Solid, body::Mesh>);

template <class... Solid>
constexpr bool are_drawn(std::type_identity<std::variant<Solid...>>) {
  return (IsDrawn<Solid> && ...);
}
static_assert(are_drawn(std::type_identity<body::Shape>()));

}  // namespace twrench::picture

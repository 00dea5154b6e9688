#pragma once

#include <twrench/body/triangle_mesh.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <variant>
#include <vector>

namespace twrench::body {

/// A solid cylinder with its axis along its local z axis. Lengths in cm.
struct Cylinder {
  /// Radius in cm.
  double radius;
  /// Length in cm.
  double length;
};

/// A solid box with edge lengths along x, y and z in cm.
struct Box {
  /// Edge lengths in cm.
  Eigen::Vector3d size;
};

/// A solid ellipsoid with semi-axes along x, y and z in cm; a sphere if they are equal.
struct Ellipsoid {
  /// Semi-axes in cm.
  Eigen::Vector3d radii;
};

/// A solid cone or frustum with its axis along its local z axis. The origin is halfway between base
/// and top. Lengths in cm.
struct Cone {
  /// Radius of the base, at z = -length/2, in cm.
  double radius;
  /// Length in cm.
  double length;
  /// Radius of the top, at z = length/2, in cm; 0 for a cone with an apex.
  double top_radius = 0.0;
};

/// A solid ring torus in its local xy plane. Lengths in cm.
struct Torus {
  /// Radius of the circle along which the tube runs, in cm.
  double radius;
  /// Radius of the tube in cm, less than `radius`.
  double tube_radius;
};

/// A solid cylinder with hemispherical ends and its axis along its local z axis. Lengths in cm.
struct Capsule {
  /// Radius of the cylinder and of its ends in cm.
  double radius;
  /// Length of the cylinder, between the centres of the hemispheres, in cm.
  double length;
};

/// A solid tube: a cylinder with a coaxial cylindrical bore, and its axis along its local z axis.
/// Lengths in cm.
struct Tube {
  /// Outer radius in cm.
  double radius;
  /// Inner radius in cm, less than `radius`.
  double inner_radius;
  /// Length in cm.
  double length;
};

/// A solid bounded by a triangle mesh, or a thin wall along one, in the mesh's own coordinates.
struct Mesh {
  /// The surface; never null.
  std::shared_ptr<const TriangleMesh> surface;
  /// Thickness of the wall in cm; 0 for a solid.
  double shell = 0.0;
  /// The integrals over the solid or the wall.
  SolidIntegrals integrals;
};

/// Returns the solid that a mesh bounds or, with `shell` > 0, the wall of that thickness in cm.
/// Throws OutOfRange or InvalidArgument as solid_integrals() and shell_integrals() do.
Mesh make_mesh(TriangleMesh surface, double shell = 0.0);

/// The geometry of a solid. The functions of a shape throw OutOfRange about a length, such as
/// "radius", that is not positive, and InvalidArgument about "mesh" if a mesh has no surface.
using Shape = std::variant<Cylinder, Box, Ellipsoid, Cone, Torus, Capsule, Tube, Mesh>;

/// A homogeneous solid, placed in the frame in which the scene describes the body.
struct Part {
  /// Geometry of the solid in its own frame.
  Shape shape;
  /// Density in g/cm^3.
  double density;
  /// Position of the origin of the shape's own frame in cm. The origin is the centroid of every
  /// shape except cones and meshes; see centroid().
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  /// Orientation, a proper rotation.
  Eigen::Matrix3d body_from_part = Eigen::Matrix3d::Identity();
};

/// Returns the volume in cm^3.
double volume(const Shape& shape);

/// Returns the centre of mass in cm, in the shape's own frame.
Eigen::Vector3d centroid(const Shape& shape);

/// Returns the inertia matrix in g cm^2 about the centroid, in the axes of the shape's own frame,
/// for `mass` grams distributed homogeneously: the integrals of eq. (13). It is diagonal for all
/// shapes except meshes. Throws OutOfRange about "mass" unless it is positive.
Eigen::Matrix3d central_inertia(const Shape& shape, double mass);

/// Returns the bounding radius in cm: the radius of the smallest sphere about `centre`, in the
/// shape's own frame, that contains the shape. For an ellipsoid that is not a sphere, it is an
/// upper bound. Throws OutOfRange about "centre" unless it is finite.
double bounding_radius(const Shape& shape, const Eigen::Vector3d& centre = Eigen::Vector3d::Zero());

/// Returns a point of the shape that lies farthest along `direction` (of any nonzero length), in
/// cm, in the shape's own frame. Throws InvalidArgument about "direction" if it is zero or not
/// finite.
Eigen::Vector3d support(const Shape& shape, const Eigen::Vector3d& direction);

/// Returns the smallest box in cm that contains the shape and has its edges along the axes of the
/// shape's own frame.
Eigen::AlignedBox3d bounding_box(const Shape& shape);

/// Returns a proper rotation whose third column is `axis` (of any nonzero length); exact for the
/// coordinate axes. Throws InvalidArgument about "axis" if it is zero or not finite. Source: Duff
/// et al., "Building an Orthonormal Basis, Revisited", JCGT 6 (2017).
Eigen::Matrix3d frame_with_z_along(const Eigen::Vector3d& axis);

}  // namespace twrench::body

#pragma once

#include <twrench/body/triangle_mesh.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <variant>
#include <vector>

namespace twrench::body {

/// A solid cylinder with its axis along z in its own frame. Lengths in cm.
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

/// A solid ellipsoid (a sphere if all are equal) with semi-axes along x, y and z in cm.
struct Ellipsoid {
  /// Semi-axes in cm.
  Eigen::Vector3d radii;
};

/// A solid cone, or a frustum, with its axis along z in its own frame, whose origin is halfway
/// between base and top. Lengths in cm.
struct Cone {
  /// Radius of the base, at z = -length/2, in cm.
  double radius;
  /// Length in cm.
  double length;
  /// Radius of the top, at z = length/2, in cm; 0 for a cone with an apex.
  double top_radius = 0.0;
};

/// A solid ring torus in the xy plane of its own frame. Lengths in cm.
struct Torus {
  /// Radius of the circle on which the centres of the tube lie, in cm.
  double radius;
  /// Radius of the tube in cm, less than `radius`.
  double tube_radius;
};

/// A solid cylinder with hemispherical ends and its axis along z in its own frame. Lengths in cm.
struct Capsule {
  /// Radius of the cylinder and of its ends in cm.
  double radius;
  /// Length of the cylinder, between the centres of the hemispheres, in cm.
  double length;
};

/// A solid of two coaxial cylinders, one hollowed out of the other, with its axis along z in its
/// own frame. Lengths in cm.
struct Tube {
  /// Outer radius in cm.
  double radius;
  /// Inner radius in cm, less than `radius`.
  double inner_radius;
  /// Length in cm.
  double length;
};

/// A solid bounded by a triangle mesh, or a thin wall along one, placed by the mesh's own
/// coordinates.
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

/// The geometry of a solid. The functions of a shape throw OutOfRange about a length that is not
/// positive, such as "radius", and InvalidArgument about "mesh" where a mesh has no surface.
using Shape = std::variant<Cylinder, Box, Ellipsoid, Cone, Torus, Capsule, Tube, Mesh>;

/// A homogeneous solid, placed in the frame in which the scene describes the body.
struct Part {
  /// Geometry of the solid in its own frame.
  Shape shape;
  /// Density in g/cm^3.
  double density;
  /// Position of the origin of the shape's own frame in cm. It is the centre of all shapes but
  /// cones and meshes, see centroid().
  Eigen::Vector3d position;
  /// Orientation, a proper rotation.
  Eigen::Matrix3d body_from_part;
};

/// Returns the volume in cm^3.
double volume(const Shape& shape);

/// Returns the centre of mass in cm, in the shape's own frame.
Eigen::Vector3d centroid(const Shape& shape);

/// Returns the inertia matrix in g cm^2 about the centroid, in the axes of the shape's own frame,
/// for `mass` grams distributed homogeneously: the integrals of eq. (13). It is diagonal for all
/// shapes but meshes. Throws OutOfRange about "mass" unless it is positive.
Eigen::Matrix3d central_inertia(const Shape& shape, double mass);

/// Returns the bounding radius in cm: that of the smallest sphere about `centre`, in the shape's
/// own frame, which contains it; of an ellipsoid that is not a sphere, a bound on it. Throws
/// OutOfRange about "centre" unless it is finite.
double bounding_radius(const Shape& shape, const Eigen::Vector3d& centre = Eigen::Vector3d::Zero());

/// Returns a point of the shape that lies farthest along `direction` (of any nonzero length), in
/// cm, in the shape's own frame. Throws InvalidArgument about "direction" if it is zero or not
/// finite.
Eigen::Vector3d support(const Shape& shape, const Eigen::Vector3d& direction);

/// Returns the smallest box with edges along the axes of the shape's own frame which contains it,
/// in cm.
Eigen::AlignedBox3d bounding_box(const Shape& shape);

/// Returns a proper rotation whose third column is `axis` (of any nonzero length); exact for the
/// coordinate axes. Throws InvalidArgument about "axis" if it is zero or not finite. Source: Duff
/// et al., "Building an Orthonormal Basis, Revisited", JCGT 6 (2017).
Eigen::Matrix3d frame_with_z_along(const Eigen::Vector3d& axis);

}  // namespace twrench::body

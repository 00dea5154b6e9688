#pragma once

#include <twrench/body/shape.h>

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

// The names and the dimensions of shapes as data, so that code that reads, writes or checks shapes
// needs no case per shape.

namespace twrench::body {

/// A dimension of a shape.
struct Dimension {
  /// Its key in scene files, also used in messages.
  std::string key;
  /// A view of the shape's member: one length in cm, or three along x, y and z.
  std::span<double> values;
  /// Whether it may be 0 and may be omitted from a scene file. All others are positive.
  bool may_be_zero = false;
  /// An earlier dimension that must be greater than this one, such as the outer radius of a tube;
  /// null if there is none.
  const double* greater = nullptr;
  /// The key of that dimension.
  std::string greater_key = {};
};

Dimension length(const char* key, double& value);
Dimension length_or_zero(const char* key, double& value);
Dimension smaller_length(const char* key, double& value, const char* greater_key,
                         const double& greater);
Dimension lengths(const char* key, Eigen::Vector3d& values);

/// Returns the dimensions of a shape as views of it.
std::vector<Dimension> dimensions(Shape& shape);

/// Throws OutOfRange or InvalidArgument unless each dimension is finite and positive (or 0 if that
/// is allowed), and less than its `greater`.
void require_dimensions(Shape shape);

/// Returns one of each shape. Dimensions that may be 0 are 0; the caller sets the others.
std::vector<Shape> all_shapes();

/// Returns the name of a shape in scene files.
std::string shape_name(const Shape& shape);

/// Returns the shape of all_shapes() with that name; nothing if there is none.
std::optional<Shape> shape_named(const std::string& name);

}  // namespace twrench::body

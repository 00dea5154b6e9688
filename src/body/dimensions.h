#pragma once

#include <twrench/body/shape.h>

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

// The names and the dimensions of shapes as values. Code that reads, writes or checks shapes needs
// no case for each shape.

namespace twrench::body {

/// A dimension of a shape.
struct Dimension {
  /// Its key in scene files, its name in messages.
  std::string key;
  /// The member of the shape: one length in cm, or three along x, y and z.
  std::span<double> values;
  /// Whether it may be 0, and a scene file may leave it out. All others are positive.
  bool may_be_zero = false;
  /// An earlier dimension that is greater than this one, such as the outer radius of a tube; null
  /// if there is none.
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

/// Throws OutOfRange or InvalidArgument unless each dimension is finite, positive or 0 where it may
/// be 0, and less than its greater one.
void require_dimensions(Shape shape);

/// Returns one of each shape. The caller sets its dimensions; those that may be 0 are.
std::vector<Shape> all_shapes();

/// Returns the name of a shape in scene files.
std::string shape_name(const Shape& shape);

/// Returns the one of all_shapes() with that name.
std::optional<Shape> shape_named(const std::string& name);

}  // namespace twrench::body

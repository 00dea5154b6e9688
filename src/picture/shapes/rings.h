#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace twrench::picture {

/// A point of a surface in the shape's own frame, cm.
struct SurfacePoint {
  Eigen::Vector3d position;
  Eigen::Vector3d normal;  ///< Outward unit normal.
};

/// A closed surface as rings with the same number of points, each counter-clockwise as seen from
/// +z. Quads connect each with the next: from the bottom (-z) to the top, or once around a hole.
struct Rings {
  std::vector<std::vector<SurfacePoint>> rings;
  /// Whether there is a hole along z: the last ring is then connected with the first; otherwise
  /// these two are filled.
  bool has_hole = false;
  /// The ring from which the side of a cylinder leads to the next one; none for other surfaces.
  std::optional<std::size_t> side = std::nullopt;
  /// Radius of the rounded rims beside that side, cm; 0 if it has none.
  double bevel = 0;
};

}  // namespace twrench::picture

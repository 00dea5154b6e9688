#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "gl/framebuffer.h"
#include "image/area.h"
#include "render/body_pass.h"
#include "render/camera.h"
#include "render/pending_layer.h"
#include "render/theme.h"

namespace twrench {

/// A level floor just below where the turning body can come: a pool of light about the place
/// beneath its centre that fades away before there is a horizon, the body's shadow and a faint
/// reflection of it. What changes is worked out at a sixth or so of the picture's resolution, for
/// it is soft.
class Floor {
 public:
  /// In the pane of a picture of that size, below parts that fill a sphere of that radius about the
  /// origin, cm. Where another pane adjoins, it fades away: floors would meet in a line.
  Floor(const gl::Functions& gl, gl::ReadMode mode, const FloorStyle& style, const Area& pane,
        const Area& picture, std::span<const Part> parts, double radius);

  /// The pool of light: the same from wherever the camera, at its height, looks at the origin.
  Layer light(const Camera& camera) const;

  /// The shadow and the reflection of the body in the pose X. The floor outlives the layer.
  PendingLayer draw(const Camera& camera, const Eigen::Matrix3d& X, const BodyPass& body);

 private:
  /// A ball of the body, to cast shadow: a part is a row of such.
  struct Ball {
    Eigen::Vector3d centre;  ///< cm, body axes
    double radius;           ///< cm
  };

  /// Whether another pane may adjoin the pane's sides.
  struct Sides {
    bool left, right, top, bottom;
  };

  /// Premultiplied red, green, blue, alpha, 0 to 255, of a cell of the grid.
  using Cell = Eigen::Array4f;

  static std::vector<Ball> balls_of(std::span<const Part> parts);
  Eigen::Matrix3d floor_from_grid(const Camera& camera, int width, int height) const;
  Area seen(const Camera& camera) const;
  float fade(double x, double y) const;
  gl::Readback begin_reflection(const Camera& camera, const Eigen::Matrix3d& X,
                                const BodyPass& body, const Area& area);
  void set_reflection(const Image& image);
  void add_shadow(const Camera& camera, const Eigen::Matrix3d& X, const Area& area);
  const Cell* row_of(int row, int width) const;
  Cell* row_of(int row, int width);
  Layer enlarged(const Area& area) const;

  FloorStyle style_;
  Area pane_;
  Sides inner_;
  double radius_;  ///< cm
  double height_;  ///< of the floor, y in space, cm; negative
  int columns_, rows_;
  gl::Framebuffer framebuffer_;  ///< of the grid's size
  std::vector<Ball> balls_;
  std::vector<Cell> grid_;  ///< of the layer being made, row by row from the top left
};

}  // namespace twrench

#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "draw/body_pass.h"
#include "draw/view_painter.h"
#include "gl/framebuffer.h"
#include "image/area.h"
#include "picture/body/shadow_balls.h"
#include "picture/look/theme.h"
#include "picture/space/camera.h"

namespace twrench::draw {

/// A horizontal floor just below the space that the rotating body sweeps. It shows a pool of light
/// around the point below the body's centre, which fades out before the horizon, and the body's
/// shadow and a faint reflection. Shadow and reflection are soft and therefore computed on a grid
/// of at most 120 rows over the picture.
class Floor {
 public:
  /// The floor fills `pane` in `picture`, below parts with the bounding radius `radius` about the
  /// origin, in cm. It fades out where another pane adjoins, because the edge of two floors would
  /// show as a line.
  Floor(const gl::Functions& gl, gl::ReadMode mode, const picture::FloorStyle& style,
        const image::Area& pane, const image::Area& picture, std::span<const body::Part> parts,
        double radius);

  /// Returns the pool of light, which is the same from every camera at this height that looks at
  /// the origin.
  picture::Layer light(const picture::Camera& camera) const;

  /// Returns the shadow and the reflection of the body in the pose X. The floor must outlive the
  /// layer.
  PendingLayer draw(const picture::Camera& camera, const Eigen::Matrix3d& X, const BodyPass& body);

 private:
  /// Whether another pane may adjoin each side of the pane.
  struct Sides {
    bool left, right, top, bottom;
  };

  using Cell = SoftLayer::Cell;

  Eigen::Matrix3d floor_from_grid(const picture::Camera& camera, int width, int height) const;
  image::Area seen(const picture::Camera& camera) const;
  float fade(double x, double y) const;
  gl::Readback begin_reflection(const picture::Camera& camera, const Eigen::Matrix3d& X,
                                const BodyPass& body, const image::Area& area);
  void add_shadow(const picture::Camera& camera, const Eigen::Matrix3d& X, const image::Area& area,
                  std::vector<Cell>& cells) const;
  SoftLayer over_pane(const image::Area& area, std::vector<Cell> cells) const;

  picture::FloorStyle style_;
  image::Area pane_;
  Sides inner_;
  double radius_;  ///< Bounding radius in cm.
  double height_;  ///< Height of the floor, y in space, in cm; negative.
  int columns_, rows_;
  /// Has two by two pixels for each cell. Multisampling would need additional programs, which would
  /// delay the first frame.
  gl::Framebuffer framebuffer_;
  std::vector<picture::Ball> balls_;
};

}  // namespace twrench::draw

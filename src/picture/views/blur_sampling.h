#pragma once

#include <twrench/body/shape.h>

#include <Eigen/Core>
#include <span>
#include <vector>

#include "image/area.h"
#include "picture/body/mesh.h"
#include "picture/space/camera.h"

namespace twrench::picture {

/// Returns whether pose `i` of `total` is one of the `count` poses of an exposure. They are evenly
/// spread, with as many before the middle of the exposure as after it.
bool is_in_exposure(int i, int count, int total);

/// The number of poses of an exposure that shows each part of the picture without visible steps:
/// the less the body moves there, the fewer.
class BlurSampling {
 public:
  /// `mesh` is that of the parts, and `radius` their bounding radius in cm.
  BlurSampling(std::span<const body::Part> parts, const Mesh& mesh, double radius);

  /// Returns for each area the number of poses to draw it in, for poses at equal intervals of time
  /// before a camera whose picture fills `pane`. The poses are then no farther apart than all of
  /// them are at the edge of the pane. One pose is enough where the body is not seen. All are
  /// needed if a part is thin, if the body turns far, or if the camera is within its bounding
  /// radius.
  std::vector<int> counts(std::span<const image::Area> areas, const Camera& camera,
                          const image::Area& pane, std::span<const Eigen::Matrix3d> poses) const;

 private:
  double thickness_;  ///< Thickness of the thinnest part, cm.
  double radius_;     ///< Bounding radius, cm.
  double reach_;      ///< No point of the surface is farther than this from one of `points_`, cm.
  std::vector<Eigen::Vector3d> points_;  ///< Points of the surface, cm, body axes.
};

}  // namespace twrench::picture

#pragma once

#include <Eigen/Core>
#include <span>

#include "image/area.h"

namespace twrench::render {

/// A perspective camera that looks at the origin of space, the centre of mass. Matrices are for
/// column vectors in OpenGL's conventions: clip = projection * view * point.
struct Camera {
  Eigen::Matrix4d view;        ///< Transform camera_from_space; the camera looks along its own -z.
  Eigen::Matrix4d projection;  ///< Transform clip_from_camera.
  double distance;             ///< Distance from the origin to the eye in cm.

  Eigen::Matrix3d camera_from_space() const { return view.topLeftCorner<3, 3>(); }
};

/// What a camera should have in view.
struct Framing {
  /// Direction from the origin to the eye, of any nonzero length.
  Eigen::Vector3d direction;
  /// Field of view along the shorter side of the picture in rad, in (0, pi).
  double field_of_view;
  /// Aspect ratio, width / height.
  double aspect;
  /// Bounding radius in cm of the sphere about the origin that must be in view.
  double radius;
  /// Distance in units of the one at which the sphere just fits.
  double distance = 1;
};

/// Returns the camera whose picture holds the sphere with a small margin at the nearer pair of
/// edges, so that it is fully in view at any aspect ratio. Space y points up in the picture; for a
/// camera on the y axis, -z does.
Camera frame_sphere(const Framing& framing);

/// Returns the smallest Framing::distance, at least 1, from which all `points` are in view with a
/// margin.
double distance_to_see(const Framing& framing, std::span<const Eigen::Vector3d> points);

/// Returns the position of a point in space in pixels from the top left, if the camera's picture
/// fills `pane`. The point must not be behind the eye.
Eigen::Vector2d pixel_of(const Camera& camera, const image::Area& pane,
                         const Eigen::Vector3d& place);

/// Returns the camera whose picture in `focus` is unchanged but extends to fill `pane`.
Camera widened(const Camera& camera, const image::Area& focus, const image::Area& pane);

/// Returns the unit vector from the origin to the eye; angles in rad.
Eigen::Vector3d direction_of(double azimuth, double elevation);

}  // namespace twrench::render

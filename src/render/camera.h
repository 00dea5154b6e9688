#pragma once

#include <Eigen/Core>
#include <span>

#include "image/area.h"

namespace twrench {

/// A perspective camera that looks at the origin of space, the centre of mass. Matrices are for
/// column vectors, in OpenGL's conventions: clip = projection * view * point.
struct Camera {
  Eigen::Matrix4d view;        ///< camera_from_space; the camera looks along its own -z
  Eigen::Matrix4d projection;  ///< clip_from_camera
  double distance;             ///< from the origin to the eye, cm

  Eigen::Matrix3d camera_from_space() const { return view.topLeftCorner<3, 3>(); }
};

/// What a camera should see.
struct Framing {
  Eigen::Vector3d direction;  ///< from the origin to the eye, any length but zero
  double field_of_view;       ///< the smaller angle of the view, rad, in (0, pi)
  double aspect;              ///< width / height
  double radius;              ///< cm, of the sphere about the origin that is to be in view
  double distance = 1;        ///< as a share of the one at which the sphere just fits
};

/// The camera from which the sphere, with a small margin, touches the nearer pair of edges, so
/// that it is whole in view at any aspect ratio. Space's y is up in the picture; seen along y
/// itself, -z is.
Camera frame_sphere(const Framing& framing);

/// The least Framing::distance, and at least 1, from which all `points` are in view, with a margin.
double distance_to_see(const Framing& framing, std::span<const Eigen::Vector3d> points);

/// A place in the picture, in pixels from its top left, where the camera's picture fills `pane`;
/// the place is not behind the eye.
Eigen::Vector2d pixel_of(const Camera& camera, const Area& pane, const Eigen::Vector3d& place);

/// The camera whose picture fills `focus`, with its picture carried on to fill `pane`.
Camera widened(const Camera& camera, const Area& focus, const Area& pane);

/// The direction from the origin to the eye, of length 1.
Eigen::Vector3d direction_of(double azimuth, double elevation);

}  // namespace twrench

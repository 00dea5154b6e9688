#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "image/area.h"

namespace twrench::picture {

/// A perspective camera that looks at the origin of space, the centre of mass. Matrices are for
/// column vectors in OpenGL's conventions: clip = projection * view * point.
struct Camera {
  /// Transform camera_from_space; the camera looks along its own -z.
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
  /// Transform clip_from_camera.
  Eigen::Matrix4d projection = Eigen::Matrix4d::Identity();
  /// Distance from the origin to the eye in cm.
  double distance = 0;

  Eigen::Matrix3d camera_from_space() const { return view.topLeftCorner<3, 3>(); }
};

/// The contents that a camera should have in view, and where.
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
  /// The point that lies in the middle of the picture, as seen from the origin, in units of half
  /// the shorter side, y up.
  Eigen::Vector2d centre{0, 0};
};

/// Returns the camera whose picture contains the sphere with a small margin at the nearer pair of
/// edges. A centred sphere is therefore fully in view at any aspect ratio. Space y points up in the
/// picture; for a camera on the y axis, -z does.
Camera frame_sphere(const Framing& framing);

/// Returns the nearest framing, with a distance of at least 1, in which the sphere and all `points`
/// are in view with a margin from each of the `directions`, and together centred.
Framing fitted(const Framing& framing, std::span<const Eigen::Vector3d> directions,
               std::span<const Eigen::Vector3d> points);

/// Returns the position of a point in space in pixels from the top left, if the camera's picture
/// fills `pane`. The point must not be behind the eye.
Eigen::Vector2d pixel_of(const Camera& camera, const image::Area& pane,
                         const Eigen::Vector3d& place);

/// Returns the camera whose picture in `focus` is unchanged but extends to fill `pane`.
Camera widened(const Camera& camera, const image::Area& focus, const image::Area& pane);

/// Returns the camera on the way from one to another. `share`, 0 to 1, is the fraction of the way.
/// The camera turns about the origin by the shortest way.
Camera between(const Camera& from, const Camera& to, double share);

/// Returns the rotation on the shortest way from one rotation to another. `share`, 0 to 1, is the
/// fraction of the way.
Eigen::Matrix3d turned(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to, double share);

/// Converts a camera for coordinates in a frame to one for coordinates in space. The frame has the
/// same origin and the attitude `space_from_frame`.
Camera carried(const Camera& camera, const Eigen::Matrix3d& space_from_frame);

/// Returns the unit vector from the origin to the eye; angles in rad.
Eigen::Vector3d direction_of(double azimuth, double elevation);

/// Returns closely spaced directions from `azimuth` through `angle`, at most one turn; only the
/// first if the angle is 0.
std::vector<Eigen::Vector3d> directions_along(double azimuth, double elevation, double angle);

}  // namespace twrench::picture

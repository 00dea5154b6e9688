#include "picture/compose/camera_path.h"

namespace twrench::picture {

Framing framing_along(const scene::Scene& scene, double aspect, double radius,
                      std::span<const Eigen::Vector3d> points) {
  const scene::CameraPath& path = scene.camera;
  const double orbit = path.orbit * scene.video_length();
  const std::vector<Eigen::Vector3d> directions =
      directions_along(path.azimuth, path.elevation, orbit);
  Framing framing =
      fitted({directions.front(), path.field_of_view, aspect, radius}, directions, points);
  framing.distance *= path.distance;
  framing.centre /= path.distance;
  return framing;
}

}  // namespace twrench::picture

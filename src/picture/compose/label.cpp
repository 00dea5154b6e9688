#include "picture/compose/label.h"

#include <Eigen/Geometry>

namespace twrench::picture {

std::optional<Label> label_at(const std::string& text, const Camera& camera,
                              const image::Area& pane, const Eigen::Vector3d& from,
                              const Eigen::Vector3d& to, const Color& color, double half_width) {
  constexpr double least_depth = 1e-3;  // in front of the eye, as a fraction of the distance
  const auto depth = [&](const Eigen::Vector3d& place) {
    return -(camera.view.row(2) * place.homogeneous()).value();
  };
  const auto is_in_front = [&](const Eigen::Vector3d& place) {
    return depth(place) > least_depth * camera.distance;
  };
  if (!is_in_front(to)) return std::nullopt;
  const Eigen::Vector2d anchor = pixel_of(camera, pane, to);
  const Eigen::Array2d within = anchor.array() - Eigen::Array2d(pane.x, pane.y);
  if (within.minCoeff() < 0 || within.x() > pane.width || within.y() > pane.height) {
    return std::nullopt;
  }
  const Eigen::Vector2d root = pixel_of(camera, pane, from);
  Eigen::Vector2d away = anchor - root;
  if (!(away.norm() > 1)) away = {0, -1};  // it points at the eye
  const double pixels_per_cm = 0.5 * camera.projection(1, 1) * pane.height / depth(to);
  return Label{text,
               anchor,
               away.normalized(),
               color,
               is_in_front(from) ? std::optional(root) : std::nullopt,
               pixels_per_cm * half_width};
}

}  // namespace twrench::picture

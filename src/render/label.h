#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "render/camera.h"
#include "scene/color.h"

namespace twrench {

/// The name of a thing in space, to be written beside it.
struct Label {
  std::string text;        ///< UTF-8
  Eigen::Vector2d anchor;  ///< the thing's end, pixels of the picture from its top left
  Eigen::Vector2d away;    ///< unit, y down: where from there the letters have room
  Color color;
};

/// That beside the end of what goes from `from` to `to` in space, where the camera's picture fills
/// `pane`; nothing where that end is out of it.
std::optional<Label> label_at(const std::string& text, const Camera& camera, const Area& pane,
                              const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                              const Color& color);

}  // namespace twrench

#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "base/color.h"
#include "picture/space/camera.h"

namespace twrench::picture {

/// The name of an object in space, drawn next to it.
struct Label {
  /// UTF-8.
  std::string text;
  /// The end of the object, in pixels from the top left of the picture.
  Eigen::Vector2d anchor;
  /// The direction in which there is room for the text: a unit vector, y down.
  Eigen::Vector2d away;
  /// Colour of the text.
  Color color;
  /// The start of the object, in pixels. Other labels avoid the line from here to the anchor.
  std::optional<Eigen::Vector2d> root = {};
  /// Half the width of the object at its end, such as the radius of an arrow's head, in pixels.
  double half_width = 0;
};

/// Returns the label at the end of an object that extends from `from` to `to` in space, for a
/// camera whose picture fills `pane`. At its end the object extends by `half_width` to each side.
/// Returns nothing if the end is outside.
std::optional<Label> label_at(const std::string& text, const Camera& camera,
                              const image::Area& pane, const Eigen::Vector3d& from,
                              const Eigen::Vector3d& to, const Color& color, double half_width = 0);

}  // namespace twrench::picture

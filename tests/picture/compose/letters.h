#pragma once

#include <Eigen/Core>
#include <cstdlib>
#include <vector>

#include "picture/compose/layer.h"

namespace twrench::picture {

/// Returns whether a pixel of the layer has that ink.
inline bool is_ink(const Layer& layer, int x, int y, const Color& ink) {
  const std::uint8_t* p =
      &layer.image.pixels[static_cast<std::size_t>(4 * (y * layer.image.width + x))];
  return std::abs(p[0] - ink.red) + std::abs(p[1] - ink.green) + std::abs(p[2] - ink.blue) < 60;
}

/// Returns the pixels of the picture with the letters of a label in that ink: those of the rows
/// with more ink than the line that leads to them has.
inline std::vector<Eigen::Vector2d> letters(const Layer& layer, const Color& ink) {
  constexpr int of_leader = 4;
  std::vector<Eigen::Vector2d> result;
  for (int y = 0; y < layer.image.height; ++y) {
    std::vector<Eigen::Vector2d> row;
    for (int x = 0; x < layer.image.width; ++x) {
      if (is_ink(layer, x, y, ink)) row.emplace_back(layer.x + x, layer.y + y);
    }
    if (row.size() > of_leader) result.insert(result.end(), row.begin(), row.end());
  }
  return result;
}

}  // namespace twrench::picture

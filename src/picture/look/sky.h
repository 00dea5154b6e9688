#pragma once

#include <Eigen/Core>
#include <vector>

namespace twrench::picture {

/// A star, at an infinite distance.
struct Star {
  /// Unit vector in space.
  Eigen::Vector3d direction;
  /// 0 to 1.
  double brightness;
  /// Green relative to red and blue.
  double tint;

  /// The radius of its soft dot in px, in a picture that is `height` pixels high. Dots are at least
  /// two pixels wide; video encoding would remove smaller ones or make them twinkle.
  double radius(int height) const;
  /// Its light in that picture, 0 to 1. A star drawn wider than its true size is fainter.
  double light(int height) const;
};

/// Returns the stars of a theme, which are the same in all pictures. In the picture of the default
/// camera at 16:9 there are `count`, as in background(); around it, stars of the same brightness
/// are spread evenly.
std::vector<Star> sky(int count);

}  // namespace twrench::picture

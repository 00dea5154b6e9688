#pragma once

#include <twrench/body/shape.h>

#include <Eigen/Core>
#include <span>
#include <vector>

namespace twrench::picture {

/// All points within `radius` of a segment. Lengths in cm, body axes.
struct Capsule {
  /// Ends of the segment.
  Eigen::Vector3d from, to;
  /// Radius about the segment.
  double radius;
  /// Whether it is a cylinder that touches the part it occludes and is drawn before it.
  bool meets = false;
  /// The index of the part that it approximates.
  std::size_t part = 0;
  /// Whether it approximates a plate, out of which it sticks on both sides. Its shadow on the floor
  /// resembles that of the plate, but it would darken the parts on the plate.
  bool is_of_plate = false;
};

/// Returns the capsules that approximate a part for soft shading: one, or several for a part
/// with hollows.
std::vector<Capsule> capsules_of(const body::Part& part);

/// Returns, for each part, the capsules of the nearest occluders, those of the other parts that are
/// close enough to shade it: nearest first, at most `most`. Plates and foil shade no other
/// parts, and foil, which shares the light of the part below, is not shaded either.
std::vector<std::vector<Capsule>> find_occluders(std::span<const body::Part> parts,
                                                 std::size_t most);

}  // namespace twrench::picture

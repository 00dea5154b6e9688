#pragma once

#include <twrench/body/shape.h>

#include <cstdint>
#include <vector>

namespace twrench::interchange {

/// A triangle mesh in the form of glTF: lengths in metres, three numbers for each vertex, and
/// triangles counter-clockwise as seen from outside.
struct Surface {
  std::vector<float> positions;
  std::vector<float> normals;  ///< Unit length, outward.
  std::vector<float> colors;   ///< Linear red, green and blue; empty without colours.
  std::vector<std::uint32_t> indices;
};

inline constexpr double metres_per_cm = 0.01;

/// Returns the surface of a part in body axes; facets deviate from it by at most `tolerance` cm. A
/// mesh keeps its triangles, smooth where they meet at no more than `crease_angle` rad.
Surface part_surface(const body::Part& part, double tolerance, double crease_angle);

/// Returns an arrow from the origin along z, of the film's shape: `length` and the radius `shaft`
/// of its shaft in cm. An arrow shorter than its head consists of the head only.
Surface arrow_surface(double length, double shaft);

}  // namespace twrench::interchange

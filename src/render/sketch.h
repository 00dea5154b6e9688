#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "render/camera.h"
#include "render/screen_area.h"
#include "scene/color.h"

namespace twrench {

/// What a thing of a sketch is drawn in.
struct Ink {
  Color color;
  double opacity = 1;  ///< 0 to 1
};

/// Lines, arrows and plain surfaces in space as a camera sees them: a list of triangles, in the
/// order in which they were added. Kept from frame to frame, so that its memory is.
///
/// All edges are smooth without multisampling. What is solid is drawn in by half a pixel, and fins
/// one pixel wide, along its outline, are drawn over it when all else that is solid is there.
class Sketch {
 public:
  struct Vertex {
    glm::vec4 clip;
    glm::vec4 paint;  ///< sRGB, premultiplied
    glm::vec3 edge;   ///< of lines and dots: pixels from the middle across, and half the width
  };

  /// A point of a line.
  struct Point {
    Eigen::Vector3d place;
    double width;  ///< pixels; under 1 the line is fainter instead of thinner
    Ink ink;
  };

  /// Forgets all; what is added from now on is seen by `camera`, whose picture fills `pane`.
  void begin(const Camera& camera, const Area& pane);

  /// A line that faces the eye, with smooth edges.
  void line(std::span<const Point> points);

  /// A round spot with a smooth edge; `radius` in pixels.
  void dot(const Eigen::Vector3d& place, double radius, const Ink& ink);

  /// A solid arrow, lit, its shaft of `radius`. One shorter than its head would be is all head.
  void arrow(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius, const Ink& ink);

  /// A flat disc that fades from `middle` to `rim`.
  void disc(const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, double radius,
            const Ink& middle, const Ink& rim);

  /// The near side of the ellipsoid about the origin that `space_from_unit` makes of the unit
  /// sphere, lit; towards its outline, where a shell of glass is thickest, with `rim`'s opacity.
  void ellipsoid(const Eigen::Matrix3d& space_from_unit, const Ink& ink, double rim);

  /// How many pixels something of length 1 at `place` is in the picture; 0 behind the eye.
  double pixels(const Eigen::Vector3d& place) const;

  const Eigen::Vector3d& eye() const { return eye_; }

  /// Adds where everything lies.
  void add_to(ScreenArea& area) const;

  const std::vector<Vertex>& vertices() const { return vertices_; }
  const std::vector<std::uint32_t>& indices() const { return indices_; }
  const std::vector<std::uint32_t>& fin_indices() const { return fin_indices_; }  ///< of arrows

 private:
  /// A point of a line in sight of the eye.
  struct Projected {
    const Point* point;
    Eigen::Vector4d clip;
    Eigen::Vector2d pixel;  ///< from the pane's middle, y up
  };

  static bool may_skip(const Projected& last, const Eigen::Vector2d& heading, const Projected& here,
                       const Projected& next);
  /// What is added from now on is another thing.
  void begin_thing() { things_.push_back(vertices_.size()); }
  void add_run();
  void add_ends(const Projected& here, const Eigen::Vector2d& across);
  Eigen::Vector4d clip(const Eigen::Vector3d& place) const;
  std::uint32_t add(const Eigen::Vector4d& clip, const Ink& ink, const glm::vec3& edge);
  std::uint32_t add_lit(const Eigen::Vector3d& place, const Eigen::Vector3d& normal,
                        const Ink& ink);
  /// A band of triangles between two rings of vertices that were added one after the other.
  void band(std::uint32_t first, std::uint32_t second, std::uint32_t count);
  struct Cone;
  void cone(const Cone& cone, const Ink& ink);
  void base(const Cone& cone, const Ink& ink);
  void add_side_fins(const Cone& cone, const Ink& ink);
  void add_rim_fins(const Cone& cone, const Ink& ink);
  /// Along the edge from `first` to `second`, vertices that were added, away from `inside`.
  void add_fin(std::uint32_t first, std::uint32_t second, const Eigen::Vector4d& inside,
               std::vector<std::uint32_t>& indices);
  /// The vertex once more, moved across by that many pixels, where the edge's coverage is so much.
  std::uint32_t add_moved(std::uint32_t vertex, const Eigen::Vector2d& pixels, float coverage);
  void soften_rim(std::uint32_t first, std::uint32_t count);
  Eigen::Vector2d pixel(std::uint32_t vertex) const;

  Eigen::Matrix4d clip_from_space_;
  Eigen::Matrix3d camera_from_space_;
  Eigen::Vector3d eye_;
  Eigen::Vector2d half_size_;   ///< of the pane, pixels
  double scale_;                ///< pixels of a length 1 at the distance 1
  std::vector<Projected> run_;  ///< of the line being added, as far as it is in sight
  std::vector<Vertex> vertices_;
  std::vector<std::size_t> things_;  ///< the first vertex of each
  std::vector<std::uint32_t> indices_, fin_indices_;
};

}  // namespace twrench

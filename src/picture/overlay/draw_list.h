#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "base/color.h"
#include "picture/space/camera.h"
#include "picture/space/screen_area.h"

namespace twrench::picture {

/// The head of an arrow: its length, and the radius of its base, in radii of the shaft.
inline constexpr double arrow_head_length = 5.5, arrow_head_radius = 2.4;

/// The colour of an item.
struct Ink {
  /// sRGB colour.
  Color color;
  /// 0 to 1.
  double opacity = 1;
};

/// A draw list: lines, arrows and plain surfaces in space as a camera sees them, as triangles in
/// the order in which they were added. It is kept from frame to frame to reuse its memory.
///
/// All edges are antialiased without multisampling. Opaque items are shrunk by half a pixel, and
/// edge quads one pixel wide along their silhouettes are drawn when all other opaque items are
/// done. Arrows have a dark or white outline, so that they stand out from whatever is behind them.
class DrawList {
 public:
  /// A vertex, with members in the order of the vertex shader's attributes.
  struct Vertex {
    /// Position in clip space.
    glm::vec4 clip;
    /// sRGB, premultiplied.
    glm::vec4 paint;
    /// For lines and dots: distance from the centre line in pixels, and half the width.
    glm::vec3 edge;
  };
  /// The edge of items that are not lines.
  static constexpr glm::vec3 no_edge{0, 0, 1e6F};

  /// A point of a line.
  struct Point {
    /// Position in space, cm.
    Eigen::Vector3d place;
    /// Width in pixels; below 1 the line becomes fainter instead of thinner.
    double width;
    /// Colour at this point.
    Ink ink;
  };

  /// Triangles, as indices of vertices.
  struct Triangles {
    /// Faces; those of arrows are anticlockwise seen from outside.
    std::vector<std::uint32_t> faces;
    /// Edge quads along the silhouettes of arrows.
    std::vector<std::uint32_t> edge_quads;
  };

  /// Clears the list; later items are seen by `camera`, whose picture fills `pane`.
  void begin(const Camera& camera, const image::Area& pane);

  /// Adds an antialiased line that faces the eye, with round ends if it is not closed.
  void line(std::span<const Point> points);

  /// Adds a line on a halo of that colour, which keeps it visible on any background.
  void line_on_halo(std::span<const Point> points, const Color& halo);

  /// Returns how many pixels a halo extends beyond an object that is `width` pixels wide.
  static double halo_of(double width) { return std::max(0.4 * width, 1.0); }

  /// Adds an antialiased dot; `radius` in pixels.
  void dot(const Eigen::Vector3d& place, double radius, const Ink& ink);

  /// Adds an opaque, shaded and outlined arrow with a shaft of `radius` cm. An arrow shorter than
  /// its head consists of the head only. It hides what it hides when it is `nearer` cm closer to
  /// the eye.
  void arrow(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius, const Ink& ink,
             double nearer = 0);

  /// Adds such an arrow along a path of at least two points, which bends little from one to the
  /// next. Its tip is the last one.
  void arrow(std::span<const Eigen::Vector3d> path, double radius, const Ink& ink,
             double nearer = 0);

  /// Adds a flat disc whose colour changes from `middle` to `rim`.
  void disc(const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, double radius,
            const Ink& middle, const Ink& rim);

  /// Adds a region of the unit sphere about the origin: from `middle` along great circles to the
  /// points of the closed `rim`. `ink_at` returns the ink of a point.
  void cap(const Eigen::Vector3d& middle, std::span<const Eigen::Vector3d> rim,
           const std::function<Ink(const Eigen::Vector3d&)>& ink_at);

  /// Adds the near side of the ellipsoid about the origin that `space_from_unit` maps the unit
  /// sphere to. It is shaded, and its opacity rises to `rim` at the silhouette, as for a glass
  /// shell. `ground` is the unshaded colour behind the glass.
  void ellipsoid(const Eigen::Matrix3d& space_from_unit, const Ink& ink, double rim,
                 const Ink& ground = {{}, 0});

  /// Returns the size in pixels of a unit length at `place`; 0 behind the eye.
  double pixels(const Eigen::Vector3d& place) const;

  /// Returns the position of the eye in space, cm.
  const Eigen::Vector3d& eye() const { return eye_; }

  /// Adds the screen areas of all items.
  void add_to(ScreenArea& area) const;

  /// Returns the value to add to z in clip space to move items towards the eye by that share of the
  /// pane's height.
  double clip_z_nearer(double share) const { return clip_z_nearer_ * share; }

  /// Return the triangles of all items.
  const std::vector<Vertex>& vertices() const { return vertices_; }
  const Triangles& items() const { return items_; }
  /// Returns arrows slightly larger than the arrows. Their far sides are the arrows' outlines.
  const Triangles& outlines() const { return outlines_; }
  /// Returns simpler arrows of few triangles, for the hidden parts of the arrows.
  const Triangles& ghosts() const { return ghosts_; }

 private:
  /// A point of a line in front of the eye.
  struct Projected {
    const Point* point;
    Eigen::Vector4d clip;
    Eigen::Vector2d pixel;  ///< From the centre of the pane, y up.
  };

  static bool may_skip(const Projected& last, const Eigen::Vector2d& heading, const Projected& here,
                       const Projected& next);
  /// Starts a new item.
  void begin_thing() { things_.push_back(vertices_.size()); }
  void add_line(std::span<const Point> points, std::vector<std::uint32_t>& faces);
  void add_run(std::vector<std::uint32_t>& faces);
  void add_end(const Projected& here, const Eigen::Vector2d& across, double forwards);
  void add_sides(const Projected& here, const Eigen::Vector2d& across,
                 const Eigen::Vector2d& beyond = Eigen::Vector2d::Zero());
  void join_sides(std::vector<std::uint32_t>& faces);
  Eigen::Vector4d clip(const Eigen::Vector3d& place) const;
  std::uint32_t add(const Eigen::Vector4d& clip, const Ink& ink, const glm::vec3& edge);
  std::uint32_t add_lit(const Eigen::Vector3d& place, const Eigen::Vector3d& normal, const Ink& ink,
                        const Ink& ground = {{}, 0});
  /// Adds a band of triangles between two consecutive rings of vertices.
  static void band(std::uint32_t first, std::uint32_t second, std::uint32_t count,
                   std::vector<std::uint32_t>& indices);
  struct Cone;
  void side(const Cone& cone, Triangles& triangles);
  void base(const Cone& cone, Triangles& triangles);
  void add_outline(std::span<const Cone> stems, const Cone& tip, double width);
  void add_ghost(std::span<const Cone> stems, const Cone& tip);
  std::uint32_t add_on(const Cone& cone, const Eigen::Vector3d& place,
                       const Eigen::Vector3d& normal);
  void add_side_edge_quads(const Cone& cone, std::vector<std::uint32_t>& indices);
  void add_rim_edge_quads(const Cone& cone, std::vector<std::uint32_t>& indices);
  /// Adds an edge quad along the edge from `first` to `second`, existing vertices, on the side
  /// opposite `inside`.
  void add_edge_quad(std::uint32_t first, std::uint32_t second, const Eigen::Vector4d& inside,
                     std::vector<std::uint32_t>& indices);
  /// Adds a copy of a vertex, displaced by that many pixels, with that coverage.
  std::uint32_t add_moved(std::uint32_t vertex, const Eigen::Vector2d& pixels, float coverage);
  void soften_rim(std::uint32_t first, std::uint32_t count);
  Eigen::Vector2d pixel(std::uint32_t vertex) const;

  Eigen::Matrix4d clip_from_space_ = Eigen::Matrix4d::Identity();
  Eigen::Matrix3d camera_from_space_ = Eigen::Matrix3d::Identity();
  Eigen::Vector3d eye_ = Eigen::Vector3d::Zero();
  Eigen::Vector2d half_size_ = Eigen::Vector2d::Zero();  ///< Half the pane's size, in pixels.
  double scale_ = 0;                                     ///< Pixels per unit length at distance 1.
  double clip_z_nearer_ = 0;                             ///< Added to z for the pane's height.
  double nearer_ = 0;                                    ///< That of the arrow being added, cm.
  std::vector<Projected> run_;                           ///< Visible part of the line being added.
  std::vector<Vertex> vertices_;
  std::vector<std::size_t> things_;  ///< First vertex of each item.
  Triangles items_, outlines_, ghosts_;
};

}  // namespace twrench::picture

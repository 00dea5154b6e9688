#include "picture/body/silhouette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <tuple>
#include <utility>

#include "picture/body/half_edges.h"

namespace twrench::picture {
namespace {

/// For each vertex the first one at the same position: corners of boxes have several, one per face.
std::vector<std::uint32_t> first_at_each_place(std::span<const Vertex> vertices) {
  const auto place = [&](std::uint32_t i) {
    const glm::vec3& p = vertices[i].position;
    return std::tuple(p.x, p.y, p.z);
  };
  return first_equal(vertices.size(),
                     [&](std::uint32_t i, std::uint32_t j) { return place(i) < place(j); });
}

/// Returns how a shift moves a vertex, in half pixels.
glm::vec3 way(const Shift& shift) {
  if (shift.offset == 0) return glm::vec3(0);
  const float length = glm::length(shift.direction);
  return shift.direction * (shift.offset * std::max(1 / length, 1.0F));
}

/// The shift that moves a vertex by this way, in half pixels.
Shift shift_by(const glm::vec3& way) {
  const float length = glm::length(way);
  return length < 1 ? Shift{way / std::max(length, 1e-6F), length} : Shift{way, 1};
}

/// Returns the normal that body.frag shows at a point of a facet. The interpolated normal is
/// shorter than 1, because the facet lies below the curved surface. The eye sees that surface above
/// the point, where the normal is as long as 1.
glm::vec3 visible_normal(const Vertex& vertex, const glm::vec3& eye) {
  const auto& [position, normal] = vertex;
  const glm::vec3 sight = glm::normalize(eye - position);
  const float along = glm::dot(normal, sight), shorter = 1 - glm::dot(normal, normal);
  return normal + (std::sqrt(std::max(along * along + shorter, 0.0F)) - along) * sight;
}

}  // namespace

Silhouette::Silhouette(const Mesh& mesh, PartIntersections intersections)
    : vertices_(mesh.vertices),
      colors_(mesh.colors),
      corners_(mesh.indices),
      intersections_(std::move(intersections)) {
  first_at_.reserve(vertices_.size());
  add_planes();
  Part begin{};
  for (std::size_t i = 0; i < mesh.part_ends.size(); ++i) {
    Part part{mesh.part_ends[i] / 3, 0, mesh.vertex_ends[i], !mesh.clusters[i].empty()};
    const auto first = static_cast<std::uint32_t>(begin.vertex_end);
    const std::span vertices(vertices_.data() + first, part.vertex_end - first);
    for (const std::uint32_t at : first_at_each_place(vertices)) first_at_.push_back(first + at);
    add_edges(begin, part);
    part.edge_end = edges_.size();
    parts_.push_back(part);
    begin = part;
  }
  on_it_.resize(vertices_.size());
  normals_inside_.resize(vertices_.size());
  for (const Vertex& vertex : vertices_) shifts_.push_back({vertex.normal, 0});
}

void Silhouette::add_planes() {
  for (std::size_t i = 0; i < corners_.size(); i += 3) {
    const glm::vec3 a = vertices_[corners_[i]].position;
    const glm::vec3 normal = glm::cross(vertices_[corners_[i + 1]].position - a,
                                        vertices_[corners_[i + 2]].position - a);
    planes_.x.push_back(a.x);
    planes_.y.push_back(a.y);
    planes_.z.push_back(a.z);
    planes_.normal_x.push_back(normal.x);
    planes_.normal_y.push_back(normal.y);
    planes_.normal_z.push_back(normal.z);
  }
  faces_eye_.resize(planes_.x.size());
}

/// Adds the edges of a part, except those in smooth hollows.
void Silhouette::add_edges(const Part& begin, const Part& part) {
  std::vector<std::uint32_t> places;
  places.reserve(3 * (part.triangle_end - begin.triangle_end));
  for (std::size_t i = 3 * begin.triangle_end; i < 3 * part.triangle_end; ++i) {
    places.push_back(place(i) - static_cast<std::uint32_t>(begin.vertex_end));
  }
  const std::vector<std::uint32_t> opposite =
      opposite_half_edges(places, part.vertex_end - begin.vertex_end);
  const auto first = static_cast<std::uint32_t>(3 * begin.triangle_end);
  for (std::uint32_t i = 0; i < opposite.size(); ++i) {
    opposite_.push_back(opposite[i] == no_half_edge ? no_half_edge : first + opposite[i]);
    if (opposite[i] == no_half_edge || opposite[i] > i) continue;
    const std::uint32_t half_edge = first + i, other = first + opposite[i];
    const bool hollow = is_hollow(half_edge, other);
    const bool crease = part.has_creases && is_crease(half_edge, other);
    if (!hollow || crease) edges_.push_back({half_edge, other, hollow, crease});
  }
}

glm::vec3 Silhouette::normal_of(std::uint32_t half_edge) const {
  const std::uint32_t triangle = half_edge / 3;
  return {planes_.normal_x[triangle], planes_.normal_y[triangle], planes_.normal_z[triangle]};
}

/// Returns whether the two triangles face each other. If one of them turns away from the eye, it is
/// in front of the other, and the edge between them is hidden wherever it is on the silhouette.
bool Silhouette::is_hollow(std::uint32_t half_edge, std::uint32_t other) const {
  const glm::vec3 normal = normal_of(half_edge);
  const std::uint32_t apex = next_half_edge(next_half_edge(other));
  const glm::vec3 across =
      vertices_[corners_[apex]].position - vertices_[corners_[half_edge]].position;
  constexpr float round_off = 1e-5F;
  return glm::dot(normal, across) > round_off * glm::length(normal) * glm::length(across);
}

/// Returns whether the shading differs visibly along the edge.
bool Silhouette::is_crease(std::uint32_t half_edge, std::uint32_t other) const {
  const glm::vec3 one = normal_of(half_edge), two = normal_of(other);
  constexpr float least_cosine = 0.97F;
  return corners_[half_edge] != corners_[next_half_edge(other)] &&
         glm::dot(one, two) < least_cosine * glm::length(one) * glm::length(two);
}

void Silhouette::find(const glm::vec3& eye, float scale) {
  face(eye);
  edge_quads_.clear();
  indices_.clear();
  part_ends_.clear();
  on_it_.assign(on_it_.size(), 0);
  normals_inside_.assign(normals_inside_.size(), glm::vec3(0));
  Part begin{};
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Part& part = parts_[i];
    find_outline(begin, part);
    if (part.has_creases) {
      point_outward(begin, part, eye);
    } else {
      for (std::size_t k = begin.vertex_end; k < part.vertex_end; ++k) shifts_[k].offset = 0;
    }
    shrink(begin, part, eye, scale);
    if (part.has_creases) {
      for (const Edge& edge : outline_) walk_inside(edge, eye, scale);
    }
    for (const Edge& edge : outline_) add_edge_quad(edge);
    for (const Edge& edge : creases_) {
      add_crease_quad(edge.half_edge, eye);
      add_crease_quad(edge.other, eye);
    }
    for (const IntersectionEdge& edge : intersections_[i]) add_intersection_quads(edge, eye, scale);
    part_ends_.push_back(indices_.size());
    begin = part;
  }
}

void Silhouette::face(const glm::vec3& eye) {
  const auto& [x, y, z, normal_x, normal_y, normal_z] = planes_;
  for (std::size_t i = 0; i < faces_eye_.size(); ++i) {
    const float towards =
        normal_x[i] * (eye.x - x[i]) + normal_y[i] * (eye.y - y[i]) + normal_z[i] * (eye.z - z[i]);
    faces_eye_[i] = towards > 0 ? 1 : 0;
  }
}

void Silhouette::find_outline(const Part& begin, const Part& part) {
  outline_.clear();
  creases_.clear();
  for (std::size_t i = begin.edge_end; i < part.edge_end; ++i) {
    const Edge& edge = edges_[i];
    if (is_seen(edge.half_edge) == is_seen(edge.other)) {
      if (edge.is_crease && is_seen(edge.other)) creases_.push_back(edge);
      continue;
    }
    if (edge.is_hollow) continue;
    outline_.push_back(edge);
    on_it_[place(edge.half_edge)] = 1;
    on_it_[place(edge.other)] = 1;
  }
}

/// Sets the directions of the shifts. At creases the normals do not determine the direction of the
/// outline, so the planes through its edges and the eye are used instead. Two edges meet in a
/// mitre.
void Silhouette::point_outward(const Part& begin, const Part& part, const glm::vec3& eye) {
  for (std::size_t i = begin.vertex_end; i < part.vertex_end; ++i) shifts_[i] = {glm::vec3(0), 0};
  for (const Edge& edge : outline_) {
    const std::uint32_t seen = seen_half_edge(edge);
    const std::uint32_t from = place(seen), to = place(next_half_edge(seen));
    const glm::vec3 outward = glm::cross(vertices_[from].position - eye,
                                         vertices_[to].position - vertices_[from].position);
    const float length = glm::length(outward);
    if (length == 0) continue;
    for (const std::uint32_t end : {from, to}) {
      shifts_[end].direction += outward / length;
      shifts_[end].offset += 1;  // temporarily the number of edges
    }
  }
  for (std::size_t i = begin.vertex_end; i < part.vertex_end; ++i) {
    auto& [direction, count] = shifts_[i];
    if (on_it_[i] == 0) continue;
    const float mean = glm::length(direction) / std::max(count, 1.0F);
    constexpr float sharpest = 0.5F;  // the cosine of half the angle by which the outline turns
    if (mean > sharpest) {
      direction /= count * mean * mean;
    } else if (mean > 0.1F) {
      direction /= count * mean;
    } else {
      direction = vertices_[i].normal;
    }
    count = 0;
  }
}

/// Walks over the mesh from the middle of an edge of the outline, a quarter of a pixel inwards, and
/// adds the normal found there to those of the edge's ends.
void Silhouette::walk_inside(const Edge& edge, const glm::vec3& eye, float scale) {
  std::uint32_t entry = seen_half_edge(edge);
  const std::uint32_t from = corners_[entry], to = corners_[next_half_edge(entry)];
  Vertex here{0.5F * (vertices_[from].position + vertices_[to].position),
              0.5F * (vertices_[from].normal + vertices_[to].normal)};
  const glm::vec3 start = here.position, sight = glm::normalize(eye - start);
  const glm::vec3 across = glm::cross(sight, vertices_[to].position - vertices_[from].position);
  const float length = glm::length(across);
  if (length == 0) return;  // the edge is seen end-on
  const glm::vec3 inward = across / length, along = glm::cross(inward, sight);
  constexpr float goal = 0.25F;       // px: the middle of what an edge quad covers of the body
  constexpr int most_triangles = 32;  // more would be far narrower than a pixel
  for (int i = 0; i < most_triangles; ++i) {
    // The path leaves the triangle on one side of its apex.
    const std::uint32_t third = next_half_edge(next_half_edge(entry));
    const Vertex& apex = vertices_[corners_[third]];
    const float apex_at = glm::dot(along, apex.position - start);
    const std::uint32_t exit = apex_at > 0 ? third : next_half_edge(entry);
    const Vertex& end = vertices_[corners_[apex_at > 0 ? entry : exit]];
    const float end_at = glm::dot(along, end.position - start);
    const float share = apex_at == end_at ? 0 : apex_at / (apex_at - end_at);
    const Vertex next{glm::mix(apex.position, end.position, share),
                      glm::mix(apex.normal, end.normal, share)};
    const float before = scale * glm::dot(inward, here.position - start);
    const float after = scale * glm::dot(inward, next.position - start);
    if (!(after > before)) break;
    const float part = std::min((goal - before) / (after - before), 1.0F);
    here = {glm::mix(here.position, next.position, part), glm::mix(here.normal, next.normal, part)};
    entry = opposite_[exit];
    if (part < 1 || entry == no_half_edge || !is_seen(entry)) break;
  }
  const glm::vec3 normal = visible_normal(here, eye);
  normals_inside_[from] += normal;
  normals_inside_[to] += normal;
}

/// The normal that edge quads show at a vertex: that of the body a little inside the outline. A
/// fillet narrower than a pixel would otherwise be a line of dots.
glm::vec3 Silhouette::normal_inside(std::uint32_t vertex) const {
  const glm::vec3& sum = normals_inside_[vertex];
  const float length = glm::length(sum);
  return length > 0 ? sum / length : vertices_[vertex].normal;
}

void Silhouette::add_edge_quad(const Edge& edge) {
  const bool is_first = is_seen(edge.half_edge);
  const std::uint32_t from = is_first ? edge.half_edge : next_half_edge(edge.other);
  const std::uint32_t to = is_first ? next_half_edge(edge.half_edge) : edge.other;
  const auto corner = [&](std::uint32_t end, float side) {
    EdgeQuadVertex vertex = quad_vertex(corners_[end]);
    vertex.shift = {shifts_[place(end)].direction, side};
    vertex.transparency = std::max(side, 0.0F);
    vertex.lift = 0.1F;  // over another part where that begins behind the outline
    vertex.normal = normal_inside(corners_[end]);
    return vertex;
  };
  add_quad({corner(from, -1), corner(from, 1), corner(to, -1), corner(to, 1)});
}

/// Adds a quad in which a triangle fades out beyond one of its edges. Like the triangle, it begins
/// where the ends of the edge are moved to.
void Silhouette::add_crease_quad(std::uint32_t half_edge, const glm::vec3& eye) {
  const std::uint32_t from = corners_[half_edge], to = corners_[next_half_edge(half_edge)];
  const glm::vec3 start = vertices_[from].position;
  const glm::vec3 outward = glm::cross(start - eye, vertices_[to].position - start);
  const float length = glm::length(outward);
  if (length == 0) return;
  const auto corner = [&](std::uint32_t end, float side) {
    EdgeQuadVertex vertex = quad_vertex(end);
    vertex.shift = shift_by(way(shifts_[end]) + side * outward / length);
    vertex.transparency = 0.5F + 0.5F * side;
    vertex.lift = 1;  // over the other triangle, where that rises towards the eye
    return vertex;
  };
  add_quad({corner(from, 0), corner(from, 1), corner(to, 0), corner(to, 1)});
}

/// Adds quads that draw the pixel around the edge again, because near a silhouette the shrunk parts
/// intersect about half a pixel beside it. The part that is drawn first covers the pixel, and the
/// other part fades out over it. Each part also covers a narrow strip of its triangle beside the
/// pixel, because parts that cross at a small angle intersect farther away. The edge is hidden if
/// either triangle faces away.
void Silhouette::add_intersection_quads(const IntersectionEdge& edge, const glm::vec3& eye,
                                        float scale) {
  if (faces_eye_[edge.triangle] == 0 || faces_eye_[edge.other] == 0) return;
  const auto& [from, to] = edge.ends;
  const glm::vec3 across = glm::cross(from.position - eye, to.position - from.position);
  const float length = glm::length(across);
  if (length == 0) return;
  const glm::vec3 outward = across / length;
  const std::array normals{visible_normal(from, eye), visible_normal(to, eye)};
  const auto corner = [&](std::size_t end, float pixels, float transparency) {
    const Shift shift{2.0F * outward, pixels};
    constexpr float lift = 3;  // over both surfaces, which rise towards the eye
    return EdgeQuadVertex{edge.ends.at(end).position, normals.at(end), shift, transparency, lift,
                          edge.colors.at(end)};
  };
  const auto add_band = [&](float begin, float end, float transparency) {
    add_quad({corner(0, begin, 0), corner(0, end, transparency), corner(1, begin, 0),
              corner(1, end, transparency)});
  };
  float width = 0;  // of the triangle, px
  for (std::size_t i = 3 * edge.triangle; i < 3 * edge.triangle + 3; ++i) {
    const glm::vec3 inwards = from.position - vertices_[corners_[i]].position;
    width = std::max(width, scale * glm::dot(outward, inwards));
  }
  // Less than 1, because the shader moves vertices with an offset of 1 to a round outline, which
  // this edge is not.
  constexpr float half = 0.5F, most = 0.65F;
  const float inside = -std::clamp(width, half, most);
  if (edge.triangle < edge.other) {
    add_band(inside, half, 0);
  } else {
    add_band(inside, -half, 0);
    add_band(-half, half, 1);
  }
}

EdgeQuadVertex Silhouette::quad_vertex(std::uint32_t vertex) const {
  const auto& [position, normal] = vertices_[vertex];
  const glm::vec3 color = colors_.empty() ? glm::vec3(0) : colors_[vertex];
  return {position, normal, {}, 0, 0, color};
}

void Silhouette::add_quad(const std::array<EdgeQuadVertex, 4>& corners) {
  const auto first = static_cast<std::uint32_t>(edge_quads_.size());
  edge_quads_.insert(edge_quads_.end(), corners.begin(), corners.end());
  indices_.insert(indices_.end(), {first, first + 1, first + 2, first + 2, first + 1, first + 3});
}

/// The distance of a vertex from the silhouette is measured on the screen: along the direction in
/// which the silhouette is moved, without its component along the line of sight.
void Silhouette::shrink(const Part& begin, const Part& part, const glm::vec3& eye, float scale) {
  for (std::size_t i = 3 * begin.triangle_end; i < 3 * part.triangle_end; i += 3) {
    const std::array places{place(i), place(i + 1), place(i + 2)};
    for (const std::uint32_t edge : places) {
      if (on_it_[edge] == 0) continue;
      const glm::vec3& position = vertices_[edge].position;
      const glm::vec3 direction = shifts_[edge].direction;
      const glm::vec3 sight = glm::normalize(eye - position);
      const glm::vec3 across = glm::normalize(direction - glm::dot(direction, sight) * sight);
      for (const std::uint32_t corner : places) {
        const float within = scale * glm::dot(across, position - vertices_[corner].position);
        if (part.has_creases && within < -0.5F) continue;  // around a corner
        const float offset = std::clamp(2 * within - 1, -1.0F, 0.0F);
        if (offset >= shifts_[corner].offset) continue;
        shifts_[corner].offset = offset;
        if (part.has_creases && on_it_[corner] == 0) shifts_[corner].direction = direction;
      }
    }
  }
  for (std::size_t i = begin.vertex_end; i < part.vertex_end; ++i) {
    const Shift& first = shifts_[first_at_[i]];
    if (part.has_creases) shifts_[i].direction = first.direction;
    shifts_[i].offset = first.offset;
  }
}

}  // namespace twrench::picture

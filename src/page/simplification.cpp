#include "page/simplification.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace twrench::page {
namespace {

using Indices = std::vector<std::uint32_t>;

/// The number of triangles that a piece always keeps, because a small piece beside a large one
/// would otherwise vanish.
constexpr std::size_t fewest_of_piece = 100;

/// Vertices, and the triangles that use only these.
struct Piece {
  std::size_t first_vertex, vertices;
  std::size_t first_index, indices;
};

std::size_t begin_of(const std::vector<std::size_t>& ends, std::size_t part) {
  return part == 0 ? 0 : ends[part - 1];
}

/// The pieces of a part: one, or the two sides of a wall, which have vertices in the same places.
std::vector<Piece> pieces_of(const picture::Mesh& mesh, std::size_t part, bool is_wall) {
  const std::size_t sides = is_wall ? 2 : 1;
  Piece piece{begin_of(mesh.vertex_ends, part), 0, begin_of(mesh.part_ends, part), 0};
  piece.vertices = (mesh.vertex_ends[part] - piece.first_vertex) / sides;
  piece.indices = (mesh.part_ends[part] - piece.first_index) / sides;
  std::vector<Piece> pieces{piece};
  if (is_wall) {
    pieces.push_back({piece.first_vertex + piece.vertices, piece.vertices,
                      piece.first_index + piece.indices, piece.indices});
  }
  return pieces;
}

/// Returns the indices of a piece that remain.
Indices simplified(const picture::Mesh& mesh, const Piece& piece, std::size_t most_indices) {
  constexpr float any_error = 1;  // in sizes of the piece
  Indices given(piece.indices), left(piece.indices);
  for (std::size_t i = 0; i < piece.indices; ++i) {
    given[i] = mesh.indices[piece.first_index + i] - static_cast<std::uint32_t>(piece.first_vertex);
  }
  const float* const places = &mesh.vertices[piece.first_vertex].position.x;
  std::size_t count =
      meshopt_simplify(left.data(), given.data(), given.size(), places, piece.vertices,
                       sizeof(picture::Vertex), most_indices, any_error, 0, nullptr);
  if (count > 2 * most_indices) {
    count = meshopt_simplifySloppy(left.data(), given.data(), given.size(), places, piece.vertices,
                                   sizeof(picture::Vertex), most_indices, any_error, nullptr);
  }
  left.resize(count);
  for (std::uint32_t& index : left) index += static_cast<std::uint32_t>(piece.first_vertex);
  return left;
}

/// Removes the vertices that no triangle uses.
void drop_unused_vertices(picture::Mesh& mesh) {
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(mesh.vertices.size(), unused);
  for (const std::uint32_t index : mesh.indices) number[index] = 0;
  std::uint32_t count = 0;
  std::size_t part = 0;
  for (std::size_t i = 0; i < number.size(); ++i) {
    while (i == mesh.vertex_ends[part]) mesh.vertex_ends[part++] = count;
    if (number[i] == unused) continue;
    mesh.vertices[count] = mesh.vertices[i];
    if (!mesh.colors.empty()) mesh.colors[count] = mesh.colors[i];
    number[i] = count++;
  }
  while (part < mesh.vertex_ends.size()) mesh.vertex_ends[part++] = count;
  mesh.vertices.resize(count);
  if (!mesh.colors.empty()) mesh.colors.resize(count);
  for (std::uint32_t& index : mesh.indices) index = number[index];
  for (auto& side : mesh.sides) {
    if (side) side->low = number[side->low], side->high = number[side->high];
  }
}

/// The number of triangles in the meshes of the parts, as given; walls have two sides.
std::size_t triangles_given(std::span<const body::Part> parts) {
  std::size_t count = 0;
  for (const body::Part& part : parts) {
    const auto* const mesh = std::get_if<body::Mesh>(&part.shape);
    if (mesh != nullptr) count += mesh->surface->triangles.size() * (mesh->shell > 0 ? 2U : 1U);
  }
  return count;
}

/// The number of triangles drawn for these parts.
std::size_t triangles_drawn(const picture::Mesh& mesh, std::span<const body::Part> parts) {
  std::size_t indices = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool is_mesh = std::holds_alternative<body::Mesh>(parts[i].shape);
    if (is_mesh) indices += mesh.part_ends[i] - begin_of(mesh.part_ends, i);
  }
  return indices / 3;
}

}  // namespace

std::optional<Simplification> simplify(picture::Mesh& mesh, std::span<const body::Part> parts,
                                       std::size_t most) {
  const std::size_t drawn = triangles_drawn(mesh, parts);
  if (drawn <= most) return std::nullopt;
  Indices indices;
  std::vector<std::size_t> ends;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t begin = begin_of(mesh.part_ends, i), end = mesh.part_ends[i];
    const std::size_t moved = indices.size();
    if (const auto* const triangles = std::get_if<body::Mesh>(&parts[i].shape)) {
      for (const Piece& piece : pieces_of(mesh, i, triangles->shell > 0)) {
        const std::size_t given = piece.indices / 3;
        const std::size_t kept = std::min(given, std::max(given * most / drawn, fewest_of_piece));
        const Indices left = simplified(mesh, piece, 3 * kept);
        indices.insert(indices.end(), left.begin(), left.end());
      }
    } else {
      indices.insert(indices.end(), mesh.indices.begin() + static_cast<std::ptrdiff_t>(begin),
                     mesh.indices.begin() + static_cast<std::ptrdiff_t>(end));
    }
    if (mesh.sides[i]) mesh.sides[i]->begin += moved - begin;
    ends.push_back(indices.size());
  }
  mesh.indices = std::move(indices);
  mesh.part_ends = std::move(ends);
  mesh.clusters.assign(parts.size(), {});
  drop_unused_vertices(mesh);
  return Simplification{triangles_given(parts), triangles_drawn(mesh, parts)};
}

}  // namespace twrench::page

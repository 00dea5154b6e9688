#include "mesh/diagnosis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/allowance.h"
#include "mesh/gaps.h"
#include "mesh/mesh_file.h"
#include "mesh/nesting.h"
#include "mesh/overlaps.h"
#include "mesh/triangle_tree.h"

namespace twrench::mesh {
namespace {

using body::TriangleMesh;
using Eigen::Vector3d;

/// Writes a point in the file's own unit, so that its author can find it.
std::string text_of(const Vector3d& point) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g})", point.x(), point.y(), point.z());
}

/// Returns "12 edges, the first from (0, 0, 0) to (0, 0, 1)".
std::string edges_text(const TriangleMesh& mesh, const std::vector<DirectedEdge>& edges) {
  const auto& [from, to] = edges.front();
  const char* const count = edges.size() == 1 ? "1 edge," : "edges, the first";
  return fmt::format("{}{} from {} to {}",
                     edges.size() == 1 ? "" : fmt::format("{} ", edges.size()), count,
                     text_of(mesh.vertices[from]), text_of(mesh.vertices[to]));
}

/// Returns "; it is also open at 5 edges", or nothing if there are no open edges.
std::string also_open(const Topology& topology) {
  if (topology.open.empty()) return {};
  return fmt::format("; it is also open at {} edge{}", topology.open.size(),
                     topology.open.size() == 1 ? "" : "s");
}

MeshError open_surface(const std::string& name, const TriangleMesh& mesh, const Topology& topology,
                       double scale) {
  const double gap = largest_gap(mesh, topology.open);
  const std::optional<double> weld = closing_tolerance(mesh, gap, scale);
  std::string why = "the surface is open at " + edges_text(mesh, topology.open);
  if (std::isfinite(gap)) why += fmt::format("; the largest gap is {:.3g} cm", gap * scale);
  const std::string wall = "make it a wall: shell = THICKNESS, in cm";
  return {MeshError::Reason::open, name, why,
          weld ? fmt::format("weld = {} closes it; or {}", *weld, wall) : "close it; or " + wall,
          weld};
}

void require_closed(const std::string& name, const TriangleMesh& mesh, const Topology& topology,
                    double scale) {
  if (!topology.branching.empty()) {
    throw InvalidArgument(name,
                          fmt::format("it is not manifold: more than two triangles meet at {}{}",
                                      edges_text(mesh, topology.branching), also_open(topology)),
                          "remove inner faces, or unite parts that touch");
  }
  if (!topology.overlapping.empty()) {
    throw InvalidArgument(
        name,
        fmt::format("the triangles that meet at {} are turned over or lie within a volume that "
                    "counts already{}",
                    edges_text(mesh, topology.overlapping), also_open(topology)),
        "unite the parts that overlap there, and turn the faces consistently");
  }
  if (!topology.opposed.empty()) {
    throw InvalidArgument(name,
                          fmt::format("its triangles disagree on which side is outside at {}{}",
                                      edges_text(mesh, topology.opposed), also_open(topology)),
                          "turn the faces consistently: modellers call it recalculating normals");
  }
  if (!topology.open.empty()) throw open_surface(name, mesh, topology, scale);
}

void turn_over(TriangleMesh& mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
}

/// Throws if the volume is no larger than what the rounding of the coordinates can produce for a
/// flat surface.
void require_volume(const std::string& name, const TriangleMesh& mesh) {
  double greatest = 0.0;
  for (const Vector3d& vertex : mesh.vertices) {
    greatest = std::max(greatest, vertex.cwiseAbs().maxCoeff());
  }
  constexpr double epsilon = 8 * std::numeric_limits<double>::epsilon();
  const double round_off = epsilon * greatest * body::surface_area(mesh);
  if (!std::isfinite(round_off) || std::abs(signed_volume(mesh)) > round_off) return;
  throw InvalidArgument(name,
                        "it encloses no volume: its faces lie upon each other, or one crosses "
                        "itself",
                        "give it a thickness, shell = THICKNESS, in cm; or correct the face");
}

void add_notes_of(const Overlap& overlap, std::vector<std::string>& notes) {
  if (overlap.is_incomplete) {
    notes.emplace_back(
        "it was not searched for triangles that cross, because too many of them are "
        "long and close to each other");
  }
  if (overlap.crossings == 0) return;
  notes.push_back(fmt::format("{} pairs of triangles cross or touch, the first near {}, {}",
                              overlap.crossings, text_of(overlap.point),
                              overlap.is_unclear ? "and whether that matters to its volume was "
                                                   "not found out, because it would take too long"
                                                 : "without effect on its volume"));
}

/// Throws if triangles cross or components lie within each other, so that some volume is not
/// counted exactly once.
void require_simple(const std::string& name, const TriangleMesh& mesh, const Topology& topology,
                    bool is_inside_out, std::vector<std::string>& notes) {
  const TriangleTree tree(mesh);
  Allowance allowance(usual_steps);
  const Overlap overlap = find_overlap(tree, is_inside_out, allowance);
  if (overlap.is_real) {
    throw InvalidArgument(
        name,
        fmt::format("it intersects itself: {} pairs of triangles cross, the first "
                    "near {}, so the volume there is not counted exactly once",
                    overlap.crossings, text_of(overlap.point)),
        "unite the parts that overlap, or make each a separate mesh");
  }
  add_notes_of(overlap, notes);
  if (const auto wrong = misplaced_component(tree, topology, is_inside_out, allowance)) {
    throw InvalidArgument(
        name,
        fmt::format("its {} components disagree: the one at {} {}", topology.components,
                    text_of(wrong->point),
                    wrong->is_within ? "is within another and turned the same way, so that its "
                                       "volume would count twice"
                                     : "is turned the other way than the rest"),
        wrong->is_within ? "turn it over for a cavity, or take it out" : "turn its faces over");
  }
  if (allowance.is_used_up() && topology.components > 1) {
    notes.emplace_back(
        "whether its components lie within each other was not found out for all, because too many "
        "of its triangles are long and close to each other");
  }
}

}  // namespace

void require_solid(const std::string& name, TriangleMesh& mesh, const Topology& topology,
                   double scale, bool search, std::vector<std::string>& notes) {
  require_closed(name, mesh, topology, scale);
  const bool is_inside_out = signed_volume(mesh) < 0.0;
  if (search) require_simple(name, mesh, topology, is_inside_out, notes);
  require_volume(name, mesh);
  if (!is_inside_out) return;
  turn_over(mesh);
  notes.emplace_back("it was inside out and has been turned over");
}

}  // namespace twrench::mesh

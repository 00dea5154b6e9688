#include "mesh/diagnosis.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "mesh/allowance.h"
#include "mesh/mesh_file.h"
#include "mesh/overlaps.h"
#include "mesh/triangle_tree.h"
#include "mesh/welding.h"

namespace twrench::mesh {
namespace {

using Eigen::Vector3d;

/// The ends of an edge as a point in six dimensions, and the index of the edge.
struct Ends {
  std::array<Vector3d, 2> ends;
  std::size_t edge;

  double coordinate(std::size_t axis) const {
    return ends[axis / 3][static_cast<Eigen::Index>(axis % 3)];
  }
};

/// Edges as a k-d tree: each part is split at the coordinate of its middle edge.
class EdgeTree {
 public:
  explicit EdgeTree(std::vector<Ends> edges) : edges_(std::move(edges)) { sort(edges_, 0); }

  /// Returns the distance to the nearest other edge: the greater distance of their ends.
  double nearest(const Ends& of, Allowance& allowance) const {
    double best = std::numeric_limits<double>::infinity();
    allowance.take(search(edges_, 0, of, best));
    return best;
  }

 private:
  static void sort(std::span<Ends> part, std::size_t axis) {
    if (part.size() < 2) return;
    const std::size_t middle = part.size() / 2;
    std::ranges::nth_element(part, part.begin() + static_cast<std::ptrdiff_t>(middle), {},
                             [axis](const Ends& e) { return e.coordinate(axis); });
    sort(part.first(middle), (axis + 1) % 6);
    sort(part.subspan(middle + 1), (axis + 1) % 6);
  }

  /// Returns the number of edges visited.
  static std::size_t search(std::span<const Ends> part, std::size_t axis, const Ends& of,
                            double& best) {
    if (part.empty()) return 0;
    const std::size_t middle = part.size() / 2;
    const Ends& here = part[middle];
    if (here.edge != of.edge) {
      best = std::min(
          best, std::max((here.ends[0] - of.ends[0]).norm(), (here.ends[1] - of.ends[1]).norm()));
    }
    const double beyond = of.coordinate(axis) - here.coordinate(axis);
    const auto before = part.first(middle), after = part.subspan(middle + 1);
    std::size_t looks = 1 + search(beyond < 0.0 ? before : after, (axis + 1) % 6, of, best);
    if (std::abs(beyond) < best) {
      looks += search(beyond < 0.0 ? after : before, (axis + 1) % 6, of, best);
    }
    return looks;
  }

  std::vector<Ends> edges_;
};

/// Returns the least number of the form 1, 2 or 5 times a power of ten that is not less than
/// `value`.
double rounded_up(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (digit * power >= value) return digit * power;
  }
  return 10.0 * power;
}

bool closes(body::TriangleMesh mesh, double tolerance) try {
  const std::size_t before = mesh.triangles.size();
  const Welded welded = weld(mesh, tolerance);
  if (100 * welded.removed_triangles > before || mesh.triangles.empty()) return false;
  return topology(mesh).is_closed();
} catch (const InvalidArgument&) {  // too many vertices are close to each other
  return false;
}

/// Returns the largest distance from an open edge to the nearest other open edge that runs the
/// opposite way. The distance of two edges is the greater distance of their ends. Infinity if there
/// is no other open edge.
double largest_gap(const body::TriangleMesh& mesh, const std::vector<DirectedEdge>& open) {
  std::vector<Ends> edges;
  for (const auto& [from, to] : open) {
    edges.push_back({{mesh.vertices[from], mesh.vertices[to]}, edges.size()});
  }
  const EdgeTree tree(edges);
  Allowance allowance(usual_steps / 10);
  double gap = 0.0;
  for (const Ends& edge : edges) {
    if (allowance.is_used_up()) return std::numeric_limits<double>::infinity();
    gap = std::max(gap, tree.nearest({{edge.ends[1], edge.ends[0]}, edge.edge}, allowance));
  }
  return gap;
}

/// Returns a tolerance at which welding closes the mesh without destroying it: a round number that
/// is not much larger than the gap. `mesh` and `gap` are in the mesh's unit, of `scale` cm; the
/// result is in cm. Nothing if there is no such tolerance.
std::optional<double> closing_tolerance(const body::TriangleMesh& mesh, double gap, double scale) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& vertex : mesh.vertices) box.extend(vertex);
  // Ends that belong together may be a few gaps apart. Anything wider is a hole rather than a gap.
  for (double tolerance = gap; tolerance > 0.0 && tolerance < 0.004 * box.diagonal().norm();
       tolerance *= 4.0) {
    const double round = rounded_up(tolerance * scale);
    if (closes(mesh, round / scale)) return round;
    if (tolerance > 10.0 * gap) break;
  }
  return {};
}

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

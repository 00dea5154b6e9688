#include "mesh/gaps.h"

#include <twrench/base/error.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "mesh/allowance.h"
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

}  // namespace

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

}  // namespace twrench::mesh

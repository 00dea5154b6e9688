#include "robot/geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "mesh/mesh_file.h"

namespace twrench::robot {
namespace {

namespace fs = std::filesystem;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double cm = 0.01;  // in m

/// Sums the mass properties of bodies.
class Sum {
 public:
  /// Adds a body with its centre, and its inertia about this centre.
  void add(double mass, const Vector3d& centre, const Matrix3d& inertia) {
    mass_ += mass;
    first_ += mass * centre;
    second_ +=
        mass * centre * centre.transpose() + 0.5 * inertia.trace() * Matrix3d::Identity() - inertia;
  }

  double mass() const { return mass_; }

  UnitBody body() const {
    const Vector3d centre = first_ / mass_;
    const Matrix3d central = second_ / mass_ - centre * centre.transpose();
    return {centre, central.trace() * Matrix3d::Identity() - central};
  }

 private:
  double mass_ = 0.0;
  Vector3d first_ = Vector3d::Zero();   ///< The integral of r dm.
  Matrix3d second_ = Matrix3d::Zero();  ///< The integral of r r^T dm.
};

/// Reads a mesh in cm. Its unit is the metre unless the file determines another. The factors of its
/// coordinates may differ, or mirror it.
mesh::MeshFile read(const fs::path& file, const Vector3d& factors, mesh::ReadOptions options = {}) {
  options.default_scale = 1.0 / cm;
  options.factor = factors[0];
  options.search = false;
  if (factors.isConstant(factors[0]) && factors[0] > 0.0) return mesh::read_mesh(file, options);
  options.factor = 1.0;
  mesh::ReadOptions as_surface = options;
  as_surface.shell = 1.0;  // any wall, because the coordinates alone are used
  as_surface.weld = 0.0;
  body::TriangleMesh surface = *mesh::read_mesh(file, as_surface).shape.surface;
  for (Vector3d& vertex : surface.vertices) vertex = vertex.cwiseProduct(factors);
  options.scale = 1.0;
  return mesh::checked_mesh(file.string(), std::move(surface), options);
}

/// The thickness of a wall does not matter, because its mass is divided out.
constexpr double any_thickness = 1.0;

double size_of(const body::TriangleMesh& surface) {
  double size = 0.0;
  for (const Vector3d& vertex : surface.vertices)
    size = std::max(size, vertex.cwiseAbs().maxCoeff());
  return size;
}

/// Reads a solid whose surface is open only because of the rounding of coordinates, as in many
/// files of CAD programs: some vertices differ by 1e-18 m. Returns nothing if it is not.
std::optional<body::Mesh> rounded_solid(const fs::path& file, const Vector3d& scale,
                                        const body::TriangleMesh& surface) {
  constexpr double rounding = 2e-7;  // of two numbers in single precision
  try {
    return read(file, scale, {.weld = rounding * size_of(surface)}).shape;
  } catch (const InvalidArgument&) {
    return std::nullopt;
  }
}

Meshes::Loaded load_mesh(const fs::path& file, const Vector3d& scale) {
  Meshes::Loaded loaded;
  try {
    loaded.solid = read(file, scale).shape;
    loaded.wall = body::make_mesh(*loaded.solid->surface, any_thickness);
    return loaded;
  } catch (const mesh::MeshError& error) {
    loaded.problem = error.what();
  } catch (const Error& error) {
    loaded.problem = error.what();
    return loaded;
  }
  loaded.wall = read(file, scale, {.shell = any_thickness}).shape;
  loaded.solid = rounded_solid(file, scale, *loaded.wall->surface);
  if (loaded.solid) loaded.problem.clear();
  return loaded;
}

/// The integrals of a shape as a solid or as a surface, in cm and for a density of 1.
std::optional<body::SolidIntegrals> integrals_of(const std::optional<body::Shape>& shape,
                                                 bool as_surface) {
  if (!shape) return std::nullopt;
  if (as_surface && !std::holds_alternative<body::Mesh>(*shape)) return wall_integrals(*shape);
  const double volume = body::volume(*shape);
  return body::SolidIntegrals{volume, body::centroid(*shape),
                              body::central_inertia(*shape, volume)};
}

std::string_view name_of(Geometry::Use use) {
  return use == Geometry::Use::visual ? "visual" : "collision";
}

}  // namespace

std::optional<fs::path> Meshes::find(const std::string& uri) const {
  const std::size_t scheme = uri.find("://");
  std::vector<fs::path> candidates;
  if (scheme == std::string::npos || uri.starts_with("file://")) {
    const fs::path path = scheme == std::string::npos ? uri : uri.substr(scheme + 3);
    candidates = {robot_.mesh_folder / path, robot_.file.parent_path() / path};
  } else {  // package://NAME/PATH and model://NAME/PATH
    const fs::path path = uri.substr(scheme + 3);
    const fs::path inside = path.lexically_relative(*path.begin());
    for (const fs::path& folder : packages_) {
      candidates.push_back(folder / path);
      candidates.push_back(folder / inside);
    }
    // A package is usually a folder that contains the robot's file.
    fs::path folder = fs::absolute(robot_.file).parent_path();
    for (; folder.has_relative_path(); folder = folder.parent_path()) {
      if (folder.filename() == *path.begin()) candidates.push_back(folder / inside);
      candidates.push_back(folder / path);
    }
    candidates.push_back(robot_.file.parent_path() / inside);
  }
  std::error_code ignored;
  const auto found = std::ranges::find_if(
      candidates, [&](const fs::path& file) { return fs::is_regular_file(file, ignored); });
  return found == candidates.end() ? std::nullopt : std::optional(*found);
}

const Meshes::Loaded& Meshes::load(const MeshReference& reference) {
  const Vector3d& s = reference.scale;
  const std::string key = fmt::format("{} {} {} {}", reference.uri, s[0], s[1], s[2]);
  if (const auto found = loaded_.find(key); found != loaded_.end()) return found->second;
  Loaded loaded;
  if (const auto file = find(reference.uri)) {
    files_.push_back(*file);
    loaded = load_mesh(*file, reference.scale);
  } else {
    missing_.insert(reference.uri);
  }
  return loaded_.emplace(key, std::move(loaded)).first->second;
}

bool is_in_package(const std::string& uri) {
  return uri.starts_with("package://") || uri.starts_with("model://");
}

LinkGeometry::LinkGeometry(const Link& link, Meshes& meshes) {
  for (const Geometry& geometry : link.geometries) add(geometry, meshes);
  is_known_ = is_known_ && !placed_.empty();
  const bool is_shell = std::ranges::any_of(placed_, &Placed::is_shell);
  for (const bool as_surface : {is_shell, !is_shell}) {
    for (const auto use : {Geometry::Use::visual, Geometry::Use::collision}) {
      if (auto model = model_of(use, as_surface)) models_.push_back(std::move(*model));
    }
  }
}

void LinkGeometry::add(const Geometry& geometry, Meshes& meshes) {
  Placed placed{
      geometry.use,     {}, {}, geometry.link_from_geometry, geometry.mass, geometry.density,
      geometry.is_shell};
  if (const auto* shape = std::get_if<body::Shape>(&geometry.shape)) {
    placed.solid = placed.surface = *shape;
  } else if (std::holds_alternative<UnknownShape>(geometry.shape)) {
    is_known_ = false;
  } else {
    const Meshes::Loaded& mesh = meshes.load(std::get<MeshReference>(geometry.shape));
    if (mesh.solid) placed.solid = *mesh.solid;
    if (mesh.wall) placed.surface = *mesh.wall;
    // The visual and the collision geometry are often the same mesh.
    const bool is_new = std::ranges::find(problems_, mesh.problem) == problems_.end();
    if (!mesh.problem.empty() && is_new) problems_.push_back(mesh.problem);
    is_known_ = is_known_ && mesh.wall.has_value();
  }
  placed_.push_back(std::move(placed));
}

std::optional<MassModel> LinkGeometry::model_of(Geometry::Use use,
                                                std::optional<bool> all_surfaces) const {
  Sum sum;
  bool states_mass = false;
  for (const Placed& placed : placed_) {
    if (placed.use != use) continue;
    states_mass = states_mass || placed.mass || placed.density;
    if (placed.mass.value_or(placed.density.value_or(1.0)) <= 0.0) continue;
    const bool as_surface = all_surfaces.value_or(placed.is_shell);
    const auto integrals = integrals_of(as_surface ? placed.surface : placed.solid, as_surface);
    if (!integrals) return std::nullopt;
    // kg, if the density is stated in kg/m^3; otherwise a weight
    const double size = integrals->volume * std::pow(cm, as_surface ? 2 : 3);
    const double mass = placed.mass.value_or(placed.density.value_or(1.0) * size);
    const Matrix3d rotation = placed.link_from_geometry.linear();
    const Matrix3d inertia = mass / integrals->volume * cm * cm * integrals->inertia;
    sum.add(mass, placed.link_from_geometry * (cm * integrals->centroid),
            rotation * inertia * rotation.transpose());
  }
  if (!(sum.mass() > 0.0)) return std::nullopt;
  const bool is_surface = all_surfaces.value_or(false);
  MassModel model{
      .source = fmt::format("{}its {} geometry", is_surface ? "the surface of " : "", name_of(use)),
      .body = sum.body()};
  if (!is_surface) model.volume = sum.mass();
  if (states_mass) model.mass = sum.mass(), model.volume.reset();
  return model;
}

Vector3d LinkGeometry::farthest(const Vector3d& direction) const {
  Vector3d best = Vector3d::Zero();
  double most = -std::numeric_limits<double>::infinity();
  for (const Placed& placed : placed_) {
    const std::optional<body::Shape>& shape = placed.solid ? placed.solid : placed.surface;
    if (!shape) continue;
    const Vector3d local = placed.link_from_geometry.linear().transpose() * direction;
    const Vector3d point = placed.link_from_geometry * (cm * body::support(*shape, local));
    if (point.dot(direction) > most) most = point.dot(direction), best = point;
  }
  return best;
}

double LinkGeometry::extent(const Vector3d& direction) const {
  return farthest(direction).dot(direction);
}

// Gilbert's algorithm (SIAM J. Control 4 (1966) 61): from the nearest point so far to the nearest
// point of the segment to the farthest point in the direction of the goal.
double LinkGeometry::distance_outside(const Vector3d& point) const {
  Vector3d nearest = farthest(Vector3d::UnitX());
  double outside = 0.0;
  for (int i = 0; i < 100; ++i) {
    const Vector3d direction = point - nearest;
    if (direction.norm() == 0.0) return 0.0;
    const Vector3d far = farthest(direction.normalized());
    outside = std::max(outside, (point - far).dot(direction.normalized()));
    const Vector3d step = far - nearest;
    if (step.squaredNorm() == 0.0) break;
    const double along = std::clamp(direction.dot(step) / step.squaredNorm(), 0.0, 1.0);
    if (along == 0.0) break;
    nearest += along * step;
  }
  return outside;
}

std::vector<body::Part> LinkGeometry::parts() const {
  std::vector<body::Part> parts;
  for (const auto use : {Geometry::Use::visual, Geometry::Use::collision}) {
    for (const Placed& placed : placed_) {
      const std::optional<body::Shape>& shape = placed.solid ? placed.solid : placed.surface;
      if (placed.use != use || !shape) continue;
      parts.push_back({.shape = *shape,
                       .density = 1.0,
                       .position = placed.link_from_geometry.translation() / cm,
                       .body_from_part = placed.link_from_geometry.linear()});
    }
    if (!parts.empty()) break;
  }
  return parts;
}

}  // namespace twrench::robot

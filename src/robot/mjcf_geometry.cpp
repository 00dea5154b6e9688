#include "robot/mjcf_geometry.h"

#include <fmt/format.h>

#include <cmath>

#include "base/words.h"
#include "robot/formats.h"

namespace twrench::robot {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

/// Places a mesh that MuJoCo shifts by `refpos`, turns by `refquat` and then scales. Returns
/// whether scaling first gives the same.
bool place(const Attributes& attributes, const Vector3d& scale, Eigen::Isometry3d& pose) {
  const Vector3d origin = attributes.vector("refpos").value_or(Vector3d::Zero());
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  if (const auto element = attributes.holder("refquat")) {
    const std::vector<Written> q = element->file->numbers(element->node, "refquat", 4);
    turn = rotation_from_quaternion(*element->file, element->node,
                                    {q[0].value, q[1].value, q[2].value, q[3].value})
               .transpose();
  }
  pose.linear() = turn;
  pose.translation() = -scale.cwiseProduct(turn * origin);
  return scale.isConstant(scale[0], 0.0) || turn.isIdentity(0.0);
}

/// The size of a geom in half lengths.
Vector3d size_of(const MjcfGeom& geom) {
  Vector3d size = geom.defaults->geom_size;
  read_size(geom.element, size);
  return size;
}

/// The ends of the axis of a geom with the attribute `fromto`.
struct Ends {
  Vector3d from, to;
};

std::optional<Ends> ends_of(const MjcfGeom& geom, const std::string& type) {
  const auto element = geom.attributes().holder("fromto");
  if (!element) return std::nullopt;
  const std::vector<Written> v = element->file->numbers(element->node, "fromto", 6);
  if (type != "capsule" && type != "cylinder" && type != "box" && type != "ellipsoid") {
    throw geom.element.bad(fmt::format("a {} has no attribute 'fromto'", type),
                           "capsules, cylinders, boxes and ellipsoids have it");
  }
  return Ends{{v[0].value, v[1].value, v[2].value}, {v[3].value, v[4].value, v[5].value}};
}

/// Returns nothing for shapes other than solids.
std::optional<body::Shape> solid_of(const Element& element, const std::string& type,
                                    const Vector3d& size) {
  const auto length = [&](double half) {
    return length_in_cm(*element.file, element.node, 2.0 * half);
  };
  const auto radius = [&](double r) { return length_in_cm(*element.file, element.node, r); };
  if (type == "sphere") return body::Ellipsoid{Vector3d::Constant(radius(size[0]))};
  if (type == "capsule") return body::Capsule{radius(size[0]), length(size[1])};
  if (type == "cylinder") return body::Cylinder{radius(size[0]), length(size[1])};
  if (type == "ellipsoid") return body::Ellipsoid{size.unaryExpr(radius)};
  if (type == "box") return body::Box{size.unaryExpr(length)};
  return std::nullopt;
}

/// Returns the pose and the size of a geom between two ends.
Eigen::Isometry3d pose_between(const MjcfGeom& geom, const Ends& ends, const std::string& type,
                               Vector3d& size) {
  const Vector3d axis = ends.from - ends.to;
  const double half = axis.norm() / 2;
  if (type == "capsule" || type == "cylinder") {
    size[1] = half;
  } else {
    size = {size[0], size[0], half};
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = (ends.from + ends.to) / 2;
  pose.linear() = rotation_of_z_axis(geom.element, axis);
  return pose;
}

const MjcfMesh& mesh_of(const MjcfGeom& geom, const MjcfMeshes& meshes) {
  const std::string name(geom.attributes().text("mesh"));
  const auto found = meshes.find(name);
  if (found != meshes.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [known, unused] : meshes) names.push_back(known);
  throw unknown_name(geom.element.place() + ": mesh", name, names);
}

void require_known(const Element& element, const std::string& type) {
  const std::vector<std::string> types{"plane",    "hfield", "sphere", "capsule", "ellipsoid",
                                       "cylinder", "box",    "mesh",   "sdf"};
  if (std::ranges::find(types, type) == types.end())
    throw unknown_name(element.place() + ": type", type, types);
}

}  // namespace

void read_mjcf_mesh(const Element& element, const MjcfDefaults& defaults,
                    const MjcfCompiler& compiler, MjcfMeshes& meshes,
                    std::vector<std::string>& notes) {
  const MjcfClass& own = defaults.find(element, element.node.attribute("class").value());
  const Attributes attributes(element, own.mesh);
  fs::path file = attributes.text("file");
  if (compiler.strips_paths) file = file.filename();
  std::string name = element.node.attribute("name").value();
  if (name.empty()) name = file.stem().string();
  const auto note = [&](const std::string& text) {
    notes.push_back(fmt::format("{}: mesh '{}' {}", element.place(), name, text));
  };
  MjcfMesh mesh;
  mesh.is_shell = attributes.text("inertia") == "shell";
  const Vector3d scale = attributes.vector("scale").value_or(Vector3d::Ones());
  if (file.empty()) {
    note("is ignored, because it names no mesh file");
  } else if (!place(attributes, scale, mesh.geom_from_mesh)) {
    note("is ignored, because it has both refquat and different scales along its axes");
  } else {
    mesh.shape = MeshReference{file.string(), scale};
  }
  if (attributes.text("inertia") == "convex") note("counts as it is, not as its convex hull");
  if (!meshes.emplace(name, std::move(mesh)).second)
    throw element.bad(fmt::format("mesh '{}' is defined twice", name), "rename one of them");
}

std::optional<Geometry> geometry_of(const MjcfGeom& geom, const MjcfMeshes& meshes,
                                    const MjcfCompiler& compiler, std::vector<std::string>& notes) {
  const Attributes attributes = geom.attributes();
  const std::string type(attributes.holder("type") ? attributes.text("type") : "sphere");
  require_known(geom.element, type);
  if (type == "plane") return std::nullopt;
  Geometry geometry{.shape = UnknownShape(),
                    .is_shell = attributes.is_true("shellinertia"),
                    .place = geom.element.place()};
  Vector3d size = size_of(geom);
  const auto ends = ends_of(geom, type);
  geometry.link_from_geometry = geom.body_from_frame * (ends ? pose_between(geom, *ends, type, size)
                                                             : pose_of(attributes, compiler));
  const bool has_mesh = attributes.holder("mesh").has_value();
  if (type == "mesh") {
    const MjcfMesh& mesh = mesh_of(geom, meshes);
    geometry.shape = mesh.shape;
    geometry.is_shell = mesh.is_shell;
    geometry.link_from_geometry = geometry.link_from_geometry * mesh.geom_from_mesh;
  } else if (const auto solid = has_mesh ? std::nullopt : solid_of(geom.element, type, size)) {
    geometry.shape = *solid;
  } else {
    notes.push_back(fmt::format("{}: a {}{} is ignored", geom.element.place(), type,
                                has_mesh ? " that is fitted to a mesh" : ""));
  }
  return geometry;
}

}  // namespace twrench::robot

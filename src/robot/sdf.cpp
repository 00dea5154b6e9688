#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "base/words.h"
#include "robot/formats.h"

// The format is described at sdformat.org/spec.

namespace twrench::robot {
namespace {

bool is_true(std::string_view text) { return text == "true" || text == "1"; }

/// A pose and its numbers.
struct SdfPose {
  Eigen::Isometry3d value = Eigen::Isometry3d::Identity();
  std::array<Written, 3> position = {};
};

/// Returns the pose of an element `<pose>`, which may be missing or empty.
SdfPose sdf_pose(const XmlFile& file, const pugi::xml_node& node) {
  SdfPose pose;
  const std::string_view format = node.attribute("rotation_format").as_string("euler_rpy");
  if (format != "euler_rpy" && format != "quat_xyzw") {
    throw file.bad(node, fmt::format("its rotation_format is '{}'", format),
                   "SDF has euler_rpy and quat_xyzw");
  }
  if (words_of(node.child_value()).empty()) return pose;
  const bool is_quaternion = format == "quat_xyzw";
  const std::vector<Written> numbers = file.numbers(node, is_quaternion ? 7 : 6);
  std::copy_n(numbers.begin(), 3, pose.position.begin());
  Eigen::VectorXd v(numbers.size());
  std::ranges::transform(numbers, v.begin(), &Written::value);
  if (!v.tail(v.size() - 3).allFinite()) throw file.bad(node, "its rotation is not finite");
  pose.value.translation() = v.head<3>();
  if (is_quaternion) {
    pose.value.linear() = rotation_from_quaternion(file, node, {v[6], v[3], v[4], v[5]});
  } else {
    const bool is_in_degrees = is_true(node.attribute("degrees").value());
    const double unit = is_in_degrees ? std::numbers::pi / 180 : 1.0;
    pose.value.linear() = rotation_from_rpy(unit * v.tail<3>());
  }
  return pose;
}

/// Reads the links of an SDF file.
class SdfReader {
 public:
  SdfReader(const XmlFile& file, Robot& robot) : file_(file), robot_(robot) {}

  void read() {
    const pugi::xml_node root = file_.root();
    has_several_models_ = count_models(root) > 1;
    robot_.name = root.child("model").attribute("name").value();
    read_models(root, "");
    for (const pugi::xml_node& world : root.children("world")) {
      if (robot_.name.empty()) robot_.name = world.attribute("name").value();
      read_models(world, "");
    }
    note_links_without_inertial();
  }

 private:
  static std::size_t count_models(const pugi::xml_node& node) {
    std::size_t count = 0;
    for (const pugi::xml_node& world : node.children("world")) count += count_models(world);
    for (const pugi::xml_node& model : node.children("model")) count += 1 + count_models(model);
    return count;
  }

  void note(const pugi::xml_node& node, const std::string& text) {
    robot_.notes.push_back(fmt::format("{}: {}", file_.place(node), text));
  }

  void note_links_without_inertial() {
    if (without_inertial_.empty()) return;
    robot_.notes.push_back(fmt::format(
        "{}: {} {} no <inertial>: SDF assumes 1 kg and moments of 1 kg m^2", file_.path().string(),
        list_of_names(without_inertial_), without_inertial_.size() == 1 ? "has" : "have"));
  }

  void read_models(const pugi::xml_node& node, const std::string& prefix);
  void read_joints(const pugi::xml_node& model, const std::string& prefix, std::size_t first);
  void read_link(const pugi::xml_node& node, const std::string& prefix);
  void read_inertial(const pugi::xml_node& node, Link& link);
  Inertial inertial_of(const pugi::xml_node& node);
  void add_geometries(const pugi::xml_node& node, Geometry::Use use, Link& link);
  std::optional<decltype(Geometry::shape)> shape_of(const pugi::xml_node& geometry);
  decltype(Geometry::shape) mesh_of(const pugi::xml_node& mesh);
  double density_of(const pugi::xml_node& node);
  Eigen::Vector3d triple(const pugi::xml_node& node);
  double length(const pugi::xml_node& node, const char* name);
  Eigen::Vector3d lengths(const pugi::xml_node& node, const char* name);
  pugi::xml_node required_child(const pugi::xml_node& node, const char* name);

  const XmlFile& file_;
  Robot& robot_;
  bool has_several_models_ = false;
  std::vector<std::string> without_inertial_;  ///< The names of links.
};

void SdfReader::read_models(const pugi::xml_node& node, const std::string& prefix) {
  for (const pugi::xml_node& include : node.children("include"))
    note(include, fmt::format("the model {} is not read", include.child("uri").child_value()));
  for (const pugi::xml_node& model : node.children("model")) {
    const std::string name(file_.required(model, "name"));
    const std::string inside = has_several_models_ ? prefix + name + "::" : "";
    const std::size_t first = robot_.links.size();
    for (const pugi::xml_node& link : model.children("link")) read_link(link, inside);
    read_models(model, inside);
    read_joints(model, inside, first);
  }
}

/// Connects links of the model and of those in it, which begin with the link `first`.
void SdfReader::read_joints(const pugi::xml_node& model, const std::string& prefix,
                            std::size_t first) {
  std::map<std::string, std::string> parent_of;
  std::set<std::string> fixed;
  for (const pugi::xml_node& joint : model.children("joint")) {
    const std::string_view parent = joint.child("parent").child_value();
    const std::string child = prefix + joint.child("child").child_value();
    if (!parent.empty() && parent != "world") parent_of[child] = prefix + std::string(parent);
    if (std::string_view(joint.attribute("type").value()) == "fixed")
      fixed.insert({prefix + std::string(parent), child});
  }
  for (std::size_t i = first; i < robot_.links.size(); ++i) {
    Link& link = robot_.links[i];
    link.is_fixed = link.is_fixed || fixed.contains(link.name);
    if (const auto parent = parent_of.find(link.name); parent != parent_of.end())
      link.parent = parent->second;
  }
}

void SdfReader::read_link(const pugi::xml_node& node, const std::string& prefix) {
  Link link{.name = prefix + std::string(file_.required(node, "name")), .line = file_.line(node)};
  add_geometries(node, Geometry::Use::visual, link);
  add_geometries(node, Geometry::Use::collision, link);
  if (const pugi::xml_node inertial = node.child("inertial")) {
    read_inertial(inertial, link);
  } else {
    link.inertial = Inertial();
    link.inertial->mass = {1.0};
    for (const Entry entry : {xx, yy, zz}) link.inertial->entries[entry] = {1.0};
    link.inertial->line = link.line;
    without_inertial_.push_back(link.name);
  }
  robot_.links.push_back(std::move(link));
}

void SdfReader::read_inertial(const pugi::xml_node& node, Link& link) {
  if (node.child("fluid_added_mass")) note(node, "its <fluid_added_mass> is not read");
  if (!is_true(node.attribute("auto").value())) {
    link.inertial = inertial_of(node);
    return;
  }
  if (node.child("mass")) {
    note(node, "its <mass> is ignored: SDF 1.12 would scale the automatic mass to it");
  }
  link.is_from_geometry = true;
  const pugi::xml_node density = node.child("density");
  const double of_link = density ? density_of(density) : default_density;
  for (Geometry& geometry : link.geometries)
    if (geometry.use == Geometry::Use::collision && !geometry.density) geometry.density = of_link;
}

Inertial SdfReader::inertial_of(const pugi::xml_node& node) {
  Inertial inertial;
  inertial.line = file_.line(node);
  const pugi::xml_node pose = node.child("pose"), mass = node.child("mass");
  if (*pose.attribute("relative_to").value() != '\0') {
    throw file_.bad(pose, "the pose of an <inertial> is relative to its link in SDF",
                    "remove the attribute relative_to");
  }
  const auto [value, position] = sdf_pose(file_, pose);
  inertial.link_from_inertial = value.linear();
  inertial.centre = position;
  inertial.mass = mass ? file_.numbers(mass, 1).front() : Written{1.0};
  const pugi::xml_node inertia = node.child("inertia");
  if (!inertia) note(node, "it has no <inertia>: SDF assumes moments of 1 kg m^2");
  for (const Entry entry : {xx, yy, zz, xy, xz, yz}) {
    const pugi::xml_node element = inertia.child(fmt::format("i{}", entry_names[entry]).c_str());
    const bool is_moment = entry == xx || entry == yy || entry == zz;
    inertial.entries[entry] =
        element ? file_.numbers(element, 1).front() : Written{is_moment ? 1.0 : 0.0};
  }
  return inertial;
}

void SdfReader::add_geometries(const pugi::xml_node& node, Geometry::Use use, Link& link) {
  const char* name = use == Geometry::Use::visual ? "visual" : "collision";
  for (const pugi::xml_node& element : node.children(name)) {
    const auto shape = shape_of(required_child(element, "geometry"));
    if (!shape) continue;
    Geometry geometry{.use = use, .shape = *shape, .place = file_.place(element)};
    const pugi::xml_node pose = element.child("pose");
    const std::string_view frame = pose.attribute("relative_to").value();
    if (!frame.empty() && frame != node.attribute("name").value()) {
      note(pose,
           fmt::format("the geometry is ignored, because its pose is relative to '{}'", frame));
      geometry.shape = UnknownShape();
    }
    geometry.link_from_geometry = sdf_pose(file_, pose).value;
    for (const double number : geometry.link_from_geometry.translation())
      file_.require_in_range(pose, "its position", number);
    if (const pugi::xml_node density = element.child("density"))
      geometry.density = density_of(density);
    link.geometries.push_back(std::move(geometry));
  }
}

/// Returns nothing for an empty geometry.
std::optional<decltype(Geometry::shape)> SdfReader::shape_of(const pugi::xml_node& geometry) {
  const pugi::xml_node node = geometry.first_child();
  const std::string_view name = node.name();
  if (name.empty() || name == "empty") return std::nullopt;
  if (name == "sphere") return body::Ellipsoid{Eigen::Vector3d::Constant(length(node, "radius"))};
  if (name == "ellipsoid") return body::Ellipsoid{lengths(node, "radii")};
  if (name == "box") return body::Box{lengths(node, "size")};
  if (name == "cylinder") return body::Cylinder{length(node, "radius"), length(node, "length")};
  if (name == "capsule") return body::Capsule{length(node, "radius"), length(node, "length")};
  if (name == "cone") return body::Cone{length(node, "radius"), length(node, "length")};
  if (name == "mesh") return mesh_of(node);
  note(node, fmt::format("<{}> is ignored, because only solids and meshes are read", name));
  return UnknownShape();
}

decltype(Geometry::shape) SdfReader::mesh_of(const pugi::xml_node& mesh) {
  if (const pugi::xml_node part = mesh.child("submesh")) {
    note(part, fmt::format("part '{}' of a mesh is ignored, because only whole meshes are read",
                           part.child("name").child_value()));
    return UnknownShape();
  }
  MeshReference reference{required_child(mesh, "uri").child_value()};
  if (const pugi::xml_node scale = mesh.child("scale")) reference.scale = triple(scale);
  return reference;
}

double SdfReader::density_of(const pugi::xml_node& node) {
  const double density = file_.numbers(node, 1).front().value;
  if (density >= 0.0 && std::isfinite(density)) return density;
  throw file_.bad(node, fmt::format("a density is {} kg/m^3", density), "densities are positive");
}

Eigen::Vector3d SdfReader::triple(const pugi::xml_node& node) {
  const std::vector<Written> v = file_.numbers(node, 3);
  for (const Written& number : v) file_.require_in_range(node, "its text", number.value);
  return {v[0].value, v[1].value, v[2].value};
}

double SdfReader::length(const pugi::xml_node& node, const char* name) {
  const pugi::xml_node element = required_child(node, name);
  return length_in_cm(file_, element, file_.numbers(element, 1).front().value);
}

Eigen::Vector3d SdfReader::lengths(const pugi::xml_node& node, const char* name) {
  const pugi::xml_node element = required_child(node, name);
  return triple(element).unaryExpr([&](double x) { return length_in_cm(file_, element, x); });
}

pugi::xml_node SdfReader::required_child(const pugi::xml_node& node, const char* name) {
  if (const pugi::xml_node child = node.child(name)) return child;
  throw file_.bad(node, fmt::format("it has no <{}>", name), "add it");
}

}  // namespace

void read_sdf(const XmlFile& file, Robot& robot) { SdfReader(file, robot).read(); }

}  // namespace twrench::robot

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "robot/formats.h"

// The format is described at wiki.ros.org/urdf/XML.

namespace twrench::robot {
namespace {

Eigen::Isometry3d pose_of(const XmlFile& file, const pugi::xml_node& origin) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = file.vector(origin, "xyz").value_or(Eigen::Vector3d::Zero());
  pose.linear() = rotation_from_rpy(file.vector(origin, "rpy").value_or(Eigen::Vector3d::Zero()));
  return pose;
}

Inertial inertial_of(const XmlFile& file, const pugi::xml_node& node) {
  Inertial inertial;
  inertial.line = file.line(node);
  const pugi::xml_node mass = node.child("mass"), inertia = node.child("inertia");
  if (!mass) throw file.bad(node, "it has no <mass>", "add <mass value=\"KG\"/>");
  if (!inertia) throw file.bad(node, "it has no <inertia>", "add it with ixx, ixy, ... izz");
  file.required(mass, "value");
  inertial.mass = file.numbers(mass, "value", 1).front();
  const pugi::xml_node origin = node.child("origin");
  const std::vector<Written> centre = file.numbers(origin, "xyz", 3);
  std::ranges::copy(centre, inertial.centre.begin());
  inertial.link_from_inertial = pose_of(file, origin).linear();
  for (const Entry entry : {xx, yy, zz, xy, xz, yz}) {
    const std::string name = fmt::format("i{}", entry_names[entry]);
    file.required(inertia, name.c_str());
    inertial.entries[entry] = file.numbers(inertia, name.c_str(), 1).front();
  }
  return inertial;
}

decltype(Geometry::shape) shape_of(const XmlFile& file, const pugi::xml_node& geometry) {
  const pugi::xml_node node = geometry.first_child();
  const std::string_view name = node.name();
  const auto length = [&](const char* attribute) {
    file.required(node, attribute);
    return length_in_cm(file, node, *file.number(node, attribute));
  };
  if (name == "sphere") return body::Ellipsoid{Eigen::Vector3d::Constant(length("radius"))};
  if (name == "cylinder") return body::Cylinder{length("radius"), length("length")};
  if (name == "capsule") return body::Capsule{length("radius"), length("length")};
  if (name == "box") {
    file.required(node, "size");
    const Eigen::Vector3d size = *file.vector(node, "size");
    return body::Box{size.unaryExpr([&](double x) { return length_in_cm(file, node, x); })};
  }
  if (name == "mesh") {
    return MeshReference{std::string(file.required(node, "filename")),
                         file.vector(node, "scale").value_or(Eigen::Vector3d::Ones())};
  }
  throw file.bad(geometry, fmt::format("it has no known shape, but '{}'", name),
                 "URDF has box, cylinder, sphere, capsule and mesh");
}

/// Whether a shape has a size of 0. Some files hide shapes in this way.
bool has_no_size(const XmlFile& file, const pugi::xml_node& geometry) {
  const pugi::xml_node shape = geometry.first_child();
  for (const char* attribute : {"size", "radius", "length"}) {
    const std::vector<Written> numbers = file.numbers(shape, attribute);
    if (std::ranges::find(numbers, 0.0, &Written::value) != numbers.end()) return true;
  }
  return false;
}

void add_geometries(const XmlFile& file, const pugi::xml_node& node, Geometry::Use use, Link& link,
                    Robot& robot) {
  const char* name = use == Geometry::Use::visual ? "visual" : "collision";
  for (const pugi::xml_node& element : node.children(name)) {
    const pugi::xml_node geometry = element.child("geometry");
    if (!geometry) throw file.bad(element, "it has no <geometry>", "add it");
    if (has_no_size(file, geometry)) {
      robot.notes.push_back(
          fmt::format("{} is ignored, because its size is 0", file.place(geometry.first_child())));
      continue;
    }
    link.geometries.push_back({.use = use,
                               .shape = shape_of(file, geometry),
                               .link_from_geometry = pose_of(file, element.child("origin")),
                               .place = file.place(element)});
  }
}

/// The joints of a file.
struct Joints {
  std::map<std::string, std::string> parent_of;
  std::set<std::string> fixed;  ///< Links with a fixed joint, to a parent or to a child.
};

Joints joints_of(const XmlFile& file) {
  Joints joints;
  for (const pugi::xml_node& joint : file.root().children("joint")) {
    const std::string parent = joint.child("parent").attribute("link").value();
    const std::string child = joint.child("child").attribute("link").value();
    joints.parent_of[child] = parent;
    if (std::string_view(joint.attribute("type").value()) != "fixed") continue;
    joints.fixed.insert({parent, child});
  }
  return joints;
}

}  // namespace

void read_urdf(const XmlFile& file, Robot& robot) {
  const pugi::xml_node root = file.root();
  robot.name = root.attribute("name").value();
  const Joints joints = joints_of(file);
  for (const pugi::xml_node& node : root.children("link")) {
    Link link{.name = std::string(file.required(node, "name")), .line = file.line(node)};
    if (const pugi::xml_node inertial = node.child("inertial"))
      link.inertial = inertial_of(file, inertial);
    add_geometries(file, node, Geometry::Use::visual, link, robot);
    add_geometries(file, node, Geometry::Use::collision, link, robot);
    if (const auto parent = joints.parent_of.find(link.name); parent != joints.parent_of.end())
      link.parent = parent->second;
    link.is_fixed = joints.fixed.contains(link.name);
    robot.links.push_back(std::move(link));
  }
}

}  // namespace twrench::robot

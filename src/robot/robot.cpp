#include "robot/robot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/words.h"
#include "robot/formats.h"
#include "robot/xml_file.h"

namespace twrench::robot {
namespace {

/// Looks for macros in elements and attributes. The comments of an expanded file still have those
/// of its source.
class FindXacro : public pugi::xml_tree_walker {
 public:
  bool is_found() const { return is_found_; }

  bool for_each(pugi::xml_node& node) override {
    is_found_ = std::string_view(node.name()).starts_with("xacro:") ||
                std::ranges::any_of(node.attributes(), [](const pugi::xml_attribute& attribute) {
                  return std::string_view(attribute.value()).starts_with("${");
                });
    return !is_found_;
  }

 private:
  bool is_found_ = false;
};

bool uses_xacro(const XmlFile& file) {
  FindXacro walker;
  pugi::xml_node root = file.root();
  root.traverse(walker);
  return file.path().extension() == ".xacro" || walker.is_found();
}

void read_format(const XmlFile& file, Robot& robot) {
  const std::string_view root = file.root().name();
  if (root == "robot") {
    robot.format = Format::urdf;
    return read_urdf(file, robot);
  }
  if (root == "sdf" || root == "gazebo") {
    robot.format = Format::sdf;
    return read_sdf(file, robot);
  }
  // The second one is usual for files that others include.
  if (root == "mujoco" || root == "mujocoinclude") {
    robot.format = Format::mjcf;
    return read_mjcf(file, robot);
  }
  throw system::FileError(fmt::format("cannot read {}", file.path().string()),
                          fmt::format("its root element is <{}>", root),
                          "URDF has <robot>, SDF has <sdf>, MJCF has <mujoco>");
}

void require_links(const XmlFile& file, const Robot& robot) {
  if (!robot.links.empty()) return;
  const bool is_part = robot.format == Format::mjcf && !file.root().child("worldbody");
  throw InvalidArgument(
      robot.file.string(),
      is_part ? "it has no <worldbody>, like a part that another file includes" : "it has no links",
      is_part ? "give the file that includes it" : "give the description of a robot");
}

void require_distinct_names(const Robot& robot) {
  std::map<std::string, std::size_t> lines;
  for (const Link& link : robot.links) {
    const auto [first, is_new] = lines.emplace(link.name, link.line);
    if (is_new) continue;
    throw InvalidArgument(
        fmt::format("{}:{}: link '{}'", robot.file.string(), link.line, link.name),
        fmt::format("line {} has a link of the same name", first->second), "rename one of them");
  }
}

Robot robot_of(const XmlFile& file) {
  const std::filesystem::path& path = file.path();
  if (uses_xacro(file)) {
    throw system::FileError(fmt::format("cannot read {}", path.string()),
                            "it has macros of xacro, which are not expanded",
                            "run xacro first: xacro FILE > robot.urdf");
  }
  Robot robot;
  robot.file = path;
  robot.text = file.text();
  robot.mesh_folder = path.parent_path();
  read_format(file, robot);
  require_links(file, robot);
  require_distinct_names(robot);
  return robot;
}

}  // namespace

Eigen::Matrix3d rotation_from_rpy(const Eigen::Vector3d& rpy) {
  return (Eigen::AngleAxisd(rpy[2], Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(rpy[1], Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(rpy[0], Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

Eigen::Matrix3d rotation_from_quaternion(const XmlFile& file, const pugi::xml_node& node,
                                         const Eigen::Quaterniond& quaternion) {
  const double norm = quaternion.norm();
  if (norm > 0.0 && std::isfinite(norm)) return quaternion.normalized().toRotationMatrix();
  throw file.bad(node, "its quaternion is zero or not finite", "give one of length 1");
}

double length_in_cm(const XmlFile& file, const pugi::xml_node& node, double metres) {
  if (metres >= 1 / largest_number && metres <= largest_number) return 100.0 * metres;
  throw file.bad(
      node, fmt::format("a length is {} m", metres),
      fmt::format("lengths are positive, from {} to {} m", 1 / largest_number, largest_number));
}

Eigen::Vector3d Inertial::centre_of_mass() const {
  return {centre[0].value, centre[1].value, centre[2].value};
}

Eigen::Matrix3d Inertial::matrix() const {
  Eigen::Matrix3d result;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto [row, column] = entry_indices[i];
    result(row, column) = result(column, row) = entries[i].value;
  }
  return result;
}

Eigen::Matrix3d Inertial::inertia() const {
  return link_from_inertial * matrix() * link_from_inertial.transpose();
}

std::size_t Robot::index(const std::string& wanted, const std::string& what) const {
  std::vector<std::string> names;
  for (const Link& link : links) names.push_back(link.name);
  const auto found = std::ranges::find(names, wanted);
  if (found == names.end()) throw unknown_name(what, wanted, names);
  return static_cast<std::size_t>(found - names.begin());
}

bool is_robot_name(const std::filesystem::path& file) {
  const std::string ending = to_lower(file.extension().string());
  constexpr std::array<std::string_view, 6> endings{".urdf", ".sdf",   ".world",
                                                    ".mjcf", ".xacro", ".xml"};
  return std::ranges::find(endings, ending) != endings.end();
}

Robot read_robot(const std::filesystem::path& path) { return robot_of(XmlFile(path)); }

Robot read_robot(std::string text, const std::filesystem::path& path) {
  return robot_of(XmlFile(std::move(text), path));
}

}  // namespace twrench::robot

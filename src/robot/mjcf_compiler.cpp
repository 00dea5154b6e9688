#include "robot/mjcf_compiler.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

#include "robot/formats.h"

namespace twrench::robot {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Returns the attribute's value among two or three. Throws InvalidArgument if it is another.
std::string choice(const Element& element, const char* attribute,
                   const std::vector<std::string>& values) {
  const std::string value = element.node.attribute(attribute).value();
  if (std::ranges::find(values, value) != values.end()) return value;
  throw element.bad(fmt::format("{} is '{}'", attribute, value),
                    fmt::format("MJCF has {}", fmt::join(values, ", ")));
}

void read_flag(const Element& element, const char* attribute, bool& flag) {
  if (element.node.attribute(attribute))
    flag = choice(element, attribute, {"true", "false"}) == "true";
}

void read_number(const Element& element, const char* attribute, double& number) {
  number = element.file->number(element.node, attribute).value_or(number);
}

/// Returns four finite numbers.
Eigen::Vector4d four(const Element& element, const char* attribute) {
  const std::vector<Written> v = element.file->numbers(element.node, attribute, 4);
  const Eigen::Vector4d result(v[0].value, v[1].value, v[2].value, v[3].value);
  if (!result.allFinite()) throw element.bad(fmt::format("{} is not finite", attribute));
  return result;
}

/// Returns the vector with length 1. Throws InvalidArgument if it is zero or not finite.
Vector3d unit(const Element& element, const Vector3d& vector) {
  const double length = vector.norm();
  if (length > 0.0 && std::isfinite(length)) return vector / length;
  throw element.bad("an axis of its rotation is zero or not finite", "give a direction");
}

Matrix3d from_xy_axes(const Element& element) {
  const std::vector<Written> v = element.file->numbers(element.node, "xyaxes", 6);
  const Vector3d x = unit(element, {v[0].value, v[1].value, v[2].value});
  const Vector3d y(v[3].value, v[4].value, v[5].value);
  Matrix3d rotation;
  rotation.col(0) = x;
  rotation.col(1) = unit(element, y - y.dot(x) * x);
  rotation.col(2) = x.cross(rotation.col(1));
  return rotation;
}

Matrix3d from_euler(const Element& element, const MjcfCompiler& compiler, double angle_unit) {
  const Vector3d angles = angle_unit * *element.file->vector(element.node, "euler");
  Matrix3d rotation = Matrix3d::Identity();
  for (int i = 0; i < 3; ++i) {
    const auto letter = static_cast<unsigned char>(compiler.euler_sequence[i]);
    const Vector3d axis = Vector3d::Unit(std::tolower(letter) - 'x');
    const Matrix3d turn = Eigen::AngleAxisd(angles[i], axis).toRotationMatrix();
    rotation = std::islower(letter) != 0 ? Matrix3d(rotation * turn) : Matrix3d(turn * rotation);
  }
  return rotation;
}

/// Returns the name of the attribute that states the rotation; nothing if there is none. As in
/// MuJoCo, a quaternion counts only if neither the element nor its class has another attribute.
std::string rotation_attribute(const Attributes& attributes) {
  const auto is_own = [&](const char* name) {
    return !attributes.own().node.attribute(name).empty();
  };
  if (std::ranges::count_if(rotation_attributes, is_own) > 1) {
    throw attributes.own().bad("it states its rotation twice",
                               "keep one of quat, axisangle, xyaxes, zaxis and euler");
  }
  std::string result = attributes.holder("quat") ? "quat" : "";
  for (const char* name : {"axisangle", "xyaxes", "zaxis", "euler"}) {
    if (is_own(name)) return name;
    if (attributes.holder(name)) result = name;
  }
  return result;
}

void read_geometry_settings(const Element& element, MjcfCompiler& compiler) {
  const pugi::xml_node node = element.node;
  if (node.attribute("inertiafromgeom")) {
    const std::string value = choice(element, "inertiafromgeom", {"false", "auto", "true"});
    compiler.from_geoms = value == "true"   ? MjcfCompiler::FromGeoms::always
                          : value == "auto" ? MjcfCompiler::FromGeoms::automatically
                                            : MjcfCompiler::FromGeoms::never;
  }
  if (node.attribute("inertiagrouprange")) {
    const std::vector<Written> groups = element.file->numbers(node, "inertiagrouprange", 2);
    compiler.groups = {groups[0].value, groups[1].value};
  }
  for (const char* attribute : {"assetdir", "meshdir"})
    if (node.attribute(attribute)) compiler.mesh_folder = node.attribute(attribute).value();
  read_flag(element, "strippath", compiler.strips_paths);
}

void read_angle_settings(const Element& element, MjcfCompiler& compiler) {
  if (element.node.attribute("angle"))
    compiler.is_in_degrees = choice(element, "angle", {"degree", "radian"}) == "degree";
  if (!element.node.attribute("eulerseq")) return;
  compiler.euler_sequence = element.node.attribute("eulerseq").value();
  const bool is_known = compiler.euler_sequence.find_first_not_of("xyzXYZ") == std::string::npos;
  if (compiler.euler_sequence.size() != 3 || !is_known) {
    throw element.bad(fmt::format("eulerseq is '{}'", compiler.euler_sequence),
                      "it has three of the letters x, y, z, X, Y and Z");
  }
}

}  // namespace

void read_compiler(const Element& element, MjcfCompiler& compiler,
                   std::vector<std::string>& notes) {
  const pugi::xml_node node = element.node;
  read_geometry_settings(element, compiler);
  read_angle_settings(element, compiler);
  CompilerSettings& settings = compiler.settings;
  read_number(element, "boundmass", settings.least_mass);
  read_number(element, "boundinertia", settings.least_moment);
  read_flag(element, "balanceinertia", settings.balances_moments);
  double total = settings.total_mass.value_or(-1.0);
  read_number(element, "settotalmass", total);
  settings.total_mass = total > 0.0 ? std::optional(total) : std::nullopt;
  if (node.attribute("coordinate") &&
      choice(element, "coordinate", {"local", "global"}) == "global") {
    throw element.bad("coordinate is 'global', but MuJoCo reads only 'local' since version 2.3.4",
                      "convert the file with MuJoCo 2.3.3");
  }
  bool fuses = false;
  read_flag(element, "fusestatic", fuses);
  if (fuses) notes.push_back(element.place() + ": fusestatic is ignored: bodies stay separate");
}

Matrix3d rotation_of_z_axis(const Element& element, const Vector3d& direction) {
  const Vector3d z = unit(element, direction);
  const Vector3d across = Vector3d::UnitZ().cross(z);
  const double sine = across.norm();
  const Vector3d axis = sine > 0.0 ? Vector3d(across / sine) : Vector3d(Vector3d::UnitX());
  return Eigen::AngleAxisd(std::atan2(sine, z[2]), axis).toRotationMatrix();
}

Matrix3d rotation_of(const Attributes& attributes, const MjcfCompiler& compiler) {
  const std::string name = rotation_attribute(attributes);
  if (name.empty()) return Matrix3d::Identity();
  const Element element = *attributes.holder(name.c_str());
  const double angle_unit = compiler.is_in_degrees ? std::numbers::pi / 180 : 1.0;
  if (name == "xyaxes") return from_xy_axes(element);
  if (name == "euler") return from_euler(element, compiler, angle_unit);
  if (name == "zaxis")
    return rotation_of_z_axis(element, *element.file->vector(element.node, "zaxis"));
  const Eigen::Vector4d v = four(element, name.c_str());
  if (name == "quat")
    return rotation_from_quaternion(*element.file, element.node, {v[0], v[1], v[2], v[3]});
  return Eigen::AngleAxisd(angle_unit * v[3], unit(element, v.head<3>())).toRotationMatrix();
}

Eigen::Isometry3d pose_of(const Attributes& attributes, const MjcfCompiler& compiler) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = attributes.vector("pos").value_or(Vector3d::Zero());
  pose.linear() = rotation_of(attributes, compiler);
  return pose;
}

}  // namespace twrench::robot

#pragma once

#include <fmt/format.h>
#include <twrench/body/mass_properties.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "robot/diagnosis.h"
#include "robot/formats.h"

// Robots with correct mass properties, and with planted mistakes.

namespace twrench::robot {

/// Random numbers that are the same on every machine.
class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}

  double between(double a, double b) {
    return a + (b - a) * static_cast<double>(engine_()) / static_cast<double>(engine_.max());
  }
  int below(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n)); }
  Eigen::Vector3d vector(double size) {
    return {between(-size, size), between(-size, size), between(-size, size)};
  }

 private:
  std::mt19937 engine_;
};

/// A link as text: numbers that a mistake may change.
struct PlantedLink {
  std::string name = "link";
  double mass = 1.0, density = 1000.0;  ///< in kg and kg/m^3
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d rpy = Eigen::Vector3d::Zero();
  /// xx, xy, xz, yy, yz, zz as they are written.
  std::array<double, 6> numbers{};
  /// <visual> and <collision> elements.
  std::string geometries;
  int digits = 9;

  Eigen::Matrix3d rotation() const { return rotation_from_rpy(rpy); }
  Eigen::Matrix3d matrix() const {
    Eigen::Matrix3d m;
    m << numbers[0], numbers[1], numbers[2], numbers[1], numbers[3], numbers[4], numbers[2],
        numbers[4], numbers[5];
    return m;
  }
  void set_matrix(const Eigen::Matrix3d& m) {
    numbers = {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
  }
  /// The inertia about the centre of mass in the axes of the link.
  Eigen::Matrix3d inertia() const { return rotation() * matrix() * rotation().transpose(); }
  void set_inertia(const Eigen::Matrix3d& I) {
    set_matrix(rotation().transpose() * I * rotation());
  }

  std::string xml() const {
    const auto list = [](const Eigen::Vector3d& v) {
      return fmt::format("{:.17g} {:.17g} {:.17g}", v[0], v[1], v[2]);
    };
    const auto number = [&](int i) { return fmt::format("{:.{}g}", numbers[i], digits); };
    return fmt::format(
        "<link name=\"{}\">\n  <inertial>\n    <origin xyz=\"{}\" rpy=\"{}\"/>\n"
        "    <mass value=\"{:.17g}\"/>\n    <inertia ixx=\"{}\" ixy=\"{}\" ixz=\"{}\" iyy=\"{}\" "
        "iyz=\"{}\" izz=\"{}\"/>\n  </inertial>\n{}</link>\n",
        name, list(centre), list(rpy), mass, number(0), number(1), number(2), number(3), number(4),
        number(5), geometries);
  }
};

inline std::string robot_xml(const std::vector<PlantedLink>& links) {
  std::string text = "<robot name=\"planted\">\n";
  for (const PlantedLink& link : links) text += link.xml();
  return text + "</robot>\n";
}

/// Writes a wedge, a solid without any symmetry, as an OBJ file, and returns the surface.
inline body::TriangleMesh write_wedge(const std::filesystem::path& file, Dice& dice, double size) {
  body::TriangleMesh mesh;
  mesh.vertices = {
      {0, 0, 0},
      {size * dice.between(0.5, 1), 0, 0},
      {size * dice.between(0, 0.3), size * dice.between(0.2, 0.9), 0},
      {size * dice.between(0, 0.5), size * dice.between(0, 0.2), size * dice.between(0.2, 0.8)}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  std::ofstream out(file);
  for (const auto& v : mesh.vertices)
    out << fmt::format("v {:.17g} {:.17g} {:.17g}\n", v[0], v[1], v[2]);
  for (const auto& t : mesh.triangles)
    out << fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return mesh;
}

/// Returns a link with correct mass properties for a random geometry: primitives, two of them, or a
/// mesh in mm. Files go to `folder`.
inline PlantedLink correct_link(const std::string& name, Dice& dice,
                                const std::filesystem::path& folder) {
  constexpr double cm = 0.01, kg_m2 = 1e-7;
  PlantedLink link;
  link.name = name;
  const double size = std::pow(10.0, dice.between(-2, 0.3));  // m
  std::vector<body::Part> parts;
  const auto add = [&](const body::Shape& shape, const std::string& element) {
    const Eigen::Vector3d at = dice.vector(size), rpy = dice.vector(1.5);
    parts.push_back({shape, 1.0, at / cm, rotation_from_rpy(rpy)});
    const std::string pose = fmt::format(
        "<origin xyz=\"{:.17g} {:.17g} {:.17g}\" rpy=\"{:.17g} "
        "{:.17g} {:.17g}\"/>",
        at[0], at[1], at[2], rpy[0], rpy[1], rpy[2]);
    link.geometries += fmt::format("  <visual>{}<geometry>{}</geometry></visual>\n", pose, element);
  };
  const auto length = [&] { return size * dice.between(0.2, 1); };
  const auto add_random = [&](int kind) {
    const double a = length(), b = length(), c = length();
    switch (kind) {
      case 0:
        return add(body::Box{Eigen::Vector3d(a, b, c) / cm},
                   fmt::format("<box size=\"{:.17g} {:.17g} {:.17g}\"/>", a, b, c));
      case 1:
        return add(body::Cylinder{a / cm, b / cm},
                   fmt::format("<cylinder radius=\"{:.17g}\" length=\"{:.17g}\"/>", a, b));
      default: {
        const std::string file = name + ".obj";
        return add(body::make_mesh(write_wedge(folder / file, dice, 1e3 * size)),
                   fmt::format("<mesh filename=\"{}\" scale=\"1e-3 1e-3 1e-3\"/>", file));
      }
    }
  };
  const int kind = dice.below(4);
  add_random(std::min(kind, 2));
  if (kind == 3) {
    add_random(0);
  } else if (kind != 2) {
    add_random(kind);
  }
  // The mesh is in mm, but its part is in cm.
  for (body::Part& part : parts) {
    if (auto* mesh = std::get_if<body::Mesh>(&part.shape)) {
      body::TriangleMesh scaled = *mesh->surface;
      for (auto& vertex : scaled.vertices) vertex *= 0.1;
      part.shape = body::make_mesh(scaled);
    }
  }
  const body::MassProperties properties = body::mass_properties(parts);
  const double density = std::pow(10.0, dice.between(2.3, 3.9)) * 1e-3;  // g/cm^3
  link.density = 1e3 * density;
  link.mass = density * properties.mass * 1e-3;
  link.centre = properties.centre_of_mass * cm;
  if (dice.below(2) == 0) link.rpy = dice.vector(1.5);
  link.digits = 6 + dice.below(9);
  link.set_inertia(density * properties.inertia * kg_m2);
  return link;
}

}  // namespace twrench::robot

#pragma once

#include <twrench/body/shape.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "system/error.h"

// Lengths are in m, masses in kg and moments of inertia in kg m^2, as in the files, except that a
// body::Shape has its usual unit, cm.

namespace twrench::robot {

/// A piece of the bytes of a file.
struct Span {
  std::size_t begin = 0, size = 0;

  std::size_t end() const { return begin + size; }
};

/// A number of a file.
struct Written {
  double value = 0.0;
  /// Half a unit of the last digit; 0 for a default, which has no digits.
  double resolution = 0.0;
  /// Nothing for a default, which is not in the file.
  std::optional<Span> place = {};
};

/// The entries of an inertia matrix, in the order in which the formats list them.
enum Entry : int { xx, yy, zz, xy, xz, yz };

/// The names of the entries.
inline constexpr std::array<std::string_view, 6> entry_names{"xx", "yy", "zz", "xy", "xz", "yz"};

/// Row and column of an entry.
inline constexpr std::array<std::array<int, 2>, 6> entry_indices{
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

/// The mass properties of a link as the file states them.
struct Inertial {
  Written mass;
  /// Centre of mass in the frame of the link.
  std::array<Written, 3> centre;
  /// Rotation from the axes of the matrix to those of the link.
  Eigen::Matrix3d link_from_inertial = Eigen::Matrix3d::Identity();
  /// The matrix about the centre of mass, by Entry.
  std::array<Written, 6> entries;
  /// For an attribute `diaginertia`, which has no room for products: the attribute, and those that
  /// state its rotation.
  std::optional<Span> diagonal = {};
  std::vector<Span> rotations = {};
  /// The line of the file.
  std::size_t line = 0;

  Eigen::Vector3d centre_of_mass() const;
  /// The matrix about the centre of mass, in the axes in which the file states it.
  Eigen::Matrix3d matrix() const;
  /// The same in the axes of the link.
  Eigen::Matrix3d inertia() const;
};

/// A reference to a mesh file.
struct MeshReference {
  /// As it was given.
  std::string uri;
  /// Factors for the coordinates, in m per unit of the file.
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
};

/// A shape that is not read, such as a height field. The notes of the robot name it.
struct UnknownShape {};

/// A solid or a surface that belongs to a link.
struct Geometry {
  /// The purpose of a geometry. In MJCF, geoms that collide with nothing are visual, except in a
  /// body whose mass properties are those of its geoms: all of them count as collision.
  enum class Use { visual, collision };

  Use use = Use::visual;
  std::variant<body::Shape, MeshReference, UnknownShape> shape;
  Eigen::Isometry3d link_from_geometry = Eigen::Isometry3d::Identity();
  /// In kg, and in kg/m^3, if stated; not both.
  std::optional<double> mass = {}, density = {};
  /// Whether the mass is on the surface.
  bool is_shell = false;
  /// For messages: "robot.urdf:12: visual".
  std::string place;
};

/// A rigid body of a robot.
struct Link {
  std::string name;
  /// Nothing if the file states no mass properties, so that they follow from the geometries, or the
  /// link is a frame.
  std::optional<Inertial> inertial = {};
  /// Whether the mass properties are those of the geometries, whatever the file states.
  bool is_from_geometry = false;
  std::vector<Geometry> geometries = {};
  /// The name of the link to which a joint connects it; empty for none.
  std::string parent = {};
  /// Whether it is fixed to the world or another link, so that simulators add up their masses.
  bool is_fixed = false;
  /// The line of the file.
  std::size_t line = 0;
};

/// Settings of an MJCF file with which MuJoCo changes mass properties when it compiles the file.
struct CompilerSettings {
  /// Lower bounds for masses in kg and principal moments in kg m^2.
  double least_mass = 0.0, least_moment = 0.0;
  /// Whether moments that violate the triangle inequality are replaced by their mean.
  bool balances_moments = false;
  /// The mass in kg to which that of all bodies together is scaled.
  std::optional<double> total_mass = {};
};

/// The formats of robot descriptions.
enum class Format { urdf, sdf, mjcf };

/// A robot description.
struct Robot {
  std::filesystem::path file;
  Format format = Format::urdf;
  std::string name;
  std::vector<Link> links;
  /// The bytes of the file.
  std::string text;
  /// The folder in which meshes without a scheme are looked for.
  std::filesystem::path mesh_folder;
  /// Nothing for formats other than MJCF.
  std::optional<CompilerSettings> compiler = {};
  /// Notes on contents that were not understood or not used, one line each.
  std::vector<std::string> notes = {};
  /// Other files that belong to it.
  std::vector<std::filesystem::path> others = {};

  /// Returns the index of a link. Throws InvalidArgument about `what`, with the nearest name, if
  /// there is none.
  std::size_t index(const std::string& wanted, const std::string& what) const;
  /// Returns the link.
  const Link& link(const std::string& wanted) const { return links[index(wanted, "link")]; }
};

/// Returns whether the name has an extension of a robot description: .urdf, .sdf, .world, .mjcf or
/// .xml, in upper or lower case.
bool is_robot_name(const std::filesystem::path& file);

/// Reads a URDF, SDF or MJCF file; the root element decides. Throws InvalidArgument about a place
/// in the file with invalid contents, and system::FileError if it cannot be read, is damaged, is
/// longer than 64 MiB, or is another kind of file, such as a xacro macro.
Robot read_robot(const std::filesystem::path& file);

/// The same with the bytes of the file, beside which other files are looked for.
Robot read_robot(std::string text, const std::filesystem::path& file);

}  // namespace twrench::robot

#pragma once

#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <string>

#include "robot/mjcf_document.h"

namespace twrench::robot {

/// The element <compiler> of an MJCF file.
struct MjcfCompiler {
  /// When the mass properties of a body are those of its geoms: automatically if it has no
  /// <inertial>.
  enum class FromGeoms { never, automatically, always };

  FromGeoms from_geoms = FromGeoms::automatically;
  /// The first and the last group of the geoms that count.
  std::array<double, 2> groups{0.0, 5.0};
  bool is_in_degrees = true;
  /// The axes of Euler's angles; those in upper case are fixed.
  std::string euler_sequence = "xyz";
  /// The folder of meshes, relative to that of the file.
  std::filesystem::path mesh_folder = {};
  /// Whether the folders in names of mesh files are dropped.
  bool strips_paths = false;
  CompilerSettings settings = {};
};

/// Reads a <compiler>. Its attributes replace those of earlier ones. Adds notes. Throws
/// InvalidArgument about a value that is not one of MJCF's.
void read_compiler(const Element& element, MjcfCompiler& compiler, std::vector<std::string>& notes);

/// Returns the rotation that the attributes `quat`, `axisangle`, `xyaxes`, `zaxis` or `euler`
/// state, or none. Throws InvalidArgument about an element with several of them or with values that
/// are no rotation.
Eigen::Matrix3d rotation_of(const Attributes& attributes, const MjcfCompiler& compiler);

/// Returns the pose that rotation_of() and the attribute `pos` state.
Eigen::Isometry3d pose_of(const Attributes& attributes, const MjcfCompiler& compiler);

/// Returns the rotation by the smallest angle that turns the z axis to the direction. Throws
/// InvalidArgument about the element if it is zero.
Eigen::Matrix3d rotation_of_z_axis(const Element& element, const Eigen::Vector3d& direction);

/// The names of the attributes of a rotation.
inline constexpr std::array<const char*, 5> rotation_attributes{"quat", "axisangle", "xyaxes",
                                                                "zaxis", "euler"};

}  // namespace twrench::robot

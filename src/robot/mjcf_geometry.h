#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robot/mjcf_compiler.h"
#include "robot/mjcf_document.h"
#include "robot/robot.h"

namespace twrench::robot {

/// A mesh of the section <asset>.
struct MjcfMesh {
  /// A reference to a mesh file, or an unknown shape.
  decltype(Geometry::shape) shape = UnknownShape();
  /// The frame of geoms with this mesh, seen from that of the file.
  Eigen::Isometry3d geom_from_mesh = Eigen::Isometry3d::Identity();
  /// Whether its mass is on the surface.
  bool is_shell = false;
};

/// The meshes of an MJCF file, by name.
using MjcfMeshes = std::map<std::string, MjcfMesh>;

/// Reads a <mesh> of the section <asset>. Adds a note about one that is not in a mesh file.
void read_mjcf_mesh(const Element& element, const MjcfDefaults& defaults,
                    const MjcfCompiler& compiler, MjcfMeshes& meshes,
                    std::vector<std::string>& notes);

/// A <geom> with the frame in the body in which it is placed, and its class.
struct MjcfGeom {
  Element element;
  Eigen::Isometry3d body_from_frame = Eigen::Isometry3d::Identity();
  const MjcfClass* defaults = nullptr;

  Attributes attributes() const { return {element, defaults->geom}; }
};

/// Returns the shape of a geom and its pose; nothing for a plane, which has no mass. Adds a note
/// about a shape that is not read. Throws InvalidArgument about a geom that MuJoCo would not read.
std::optional<Geometry> geometry_of(const MjcfGeom& geom, const MjcfMeshes& meshes,
                                    const MjcfCompiler& compiler, std::vector<std::string>& notes);

}  // namespace twrench::robot

#pragma once

#include <twrench/body/mass_properties.h>

#include <string>
#include <vector>

#include "app/options/command_line.h"
#include "mesh/mesh_file.h"
#include "scene/scene.h"

namespace twrench::app {

/// A mesh that was read, as a body.
struct MeshBody {
  mesh::MeshFile file;
  body::MassProperties properties;
};

/// The options that say what a mesh file does not: its unit, its density, how it is closed. Must
/// live as long as the command.
class MeshOptions {
 public:
  explicit MeshOptions(CLI::App& command);

  /// Throws InvalidArgument where one of the options is given, as for a scene they mean nothing.
  void require_none() const;

  /// Returns the options that were given, as words of a command line.
  std::vector<std::string> given() const;

  /// Reads the mesh. Warns on standard error of what was changed. Throws as read_mesh() does, with
  /// these options as the remedies, and InvalidArgument about them.
  MeshBody read(const std::string& file) const;

  /// Loads the scene of a mesh without warnings. Throws as read(), and as scene::mesh_scene().
  scene::Scene scene(const std::string& file) const;

 private:
  mesh::ReadOptions read_options() const;
  double density(double volume) const;

  CLI::App& command_;
  std::string unit_, scale_, density_ = "1", mass_, weld_ = "0", shell_;
};

}  // namespace twrench::app

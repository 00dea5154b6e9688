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

/// The options for what a mesh file does not specify: its unit, its density, and how it is closed.
/// Must live as long as the command.
class MeshOptions {
 public:
  explicit MeshOptions(CLI::App& command);

  /// Throws InvalidArgument if one of the options is given; they have no meaning for a scene.
  void require_none() const;

  /// Returns the options that were given, as words of a command line.
  std::vector<std::string> given() const;

  /// Reads the mesh. Warns on standard error about repairs. Throws the errors of read_mesh(), with
  /// remedies that name these options, and InvalidArgument about the options.
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

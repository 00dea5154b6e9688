#include "app/options/mesh_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>

#include "app/options/arguments.h"
#include "app/options/command_line.h"
#include "app/terminal/message.h"
#include "scene/limits.h"
#include "scene/mesh_scene.h"

namespace twrench::app {
namespace {

/// The remedy in terms of options instead of the keys of a scene file.
std::string remedy_in_options(const mesh::MeshError& error) {
  if (error.reason() == mesh::MeshError::Reason::no_scale) {
    return "add --unit mm, cm, m, inch or km, or --scale F for F cm";
  }
  const std::string shell = "--shell T makes it a wall of that thickness in cm";
  return error.weld() ? fmt::format("--weld {} closes it; or {}", *error.weld(), shell)
                      : "close it; or " + shell;
}

/// Calls `read`; the remedies of its errors name options.
auto with_remedies_in_options(const auto& read) try {
  return read();
} catch (const mesh::MeshError& error) {
  throw error.with_remedy(remedy_in_options(error));
}

constexpr std::array mesh_option_names{"--unit", "--scale", "--density",
                                       "--mass", "--weld",  "--shell"};

}  // namespace

MeshOptions::MeshOptions(CLI::App& command) : command_(command) {
  command.add_option("--unit", unit_, "of a mesh: the unit of its file: mm, cm, m, inch or km")
      ->check(one_of("--unit", mesh::unit_names()))
      ->type_name("UNIT")
      ->default_str("m for glTF, that of the file for COLLADA and 3MF")
      ->group(heading(OptionGroup::body));
  command.add_option("--scale", scale_, "of a mesh: the same as a number, cm per unit")
      ->type_name("F")
      ->default_str("by --unit")
      ->group(heading(OptionGroup::body));
  command.add_option("--density", density_, "of a mesh: its density, g/cm^3")
      ->type_name("D")
      ->capture_default_str()
      ->group(heading(OptionGroup::body));
  command.add_option("--mass", mass_, "of a mesh: its mass, g")
      ->type_name("M")
      ->default_str("by --density")
      ->group(heading(OptionGroup::body));
  command.add_option("--weld", weld_, "of a mesh: join vertices up to this far apart, cm")
      ->type_name("T")
      ->capture_default_str()
      ->group(heading(OptionGroup::body));
  command
      .add_option("--shell", shell_, "of a mesh: a wall of this thickness along its surface, cm")
      ->type_name("T")
      ->default_str("a solid")
      ->group(heading(OptionGroup::body));
}

void MeshOptions::require_none() const {
  for (const char* option : mesh_option_names) {
    if (command_.count(option) == 0) continue;
    throw InvalidArgument(option, "is for a mesh, and this is none",
                          "name a file that ends in .obj, .stl, .ply, .gltf, .glb, .dae or .3mf");
  }
}

std::vector<std::string> MeshOptions::given() const {
  return given_options(command_, {mesh_option_names.begin(), mesh_option_names.end()});
}

mesh::ReadOptions MeshOptions::read_options() const {
  if (!unit_.empty() && !scale_.empty()) {
    throw InvalidArgument("--scale", "--unit gives it already", "leave out one of them");
  }
  if (!mass_.empty() && command_.count("--density") > 0) {
    throw InvalidArgument("--mass", "--density determines it", "leave out one of them");
  }
  mesh::ReadOptions options;
  if (!unit_.empty()) options.scale = mesh::unit_length("--unit", unit_);
  if (!scale_.empty()) options.scale = parse_number(scale_, "--scale", scene::limits::mesh_scale);
  if (!shell_.empty()) options.shell = parse_number(shell_, "--shell", scene::limits::length);
  options.weld = parse_number(weld_, "--weld", scene::limits::length_or_none);
  return options;
}

double MeshOptions::density(double volume) const {
  if (mass_.empty()) return parse_number(density_, "--density", scene::limits::density);
  return scene::limits::density_of_mass("--mass", parse_number(mass_, "--mass"), volume);
}

MeshBody MeshOptions::read(const std::string& file) const {
  mesh::MeshFile mesh = with_remedies_in_options(
      [&] { return mesh::read_mesh(std::filesystem::path(file), read_options()); });
  for (const std::string& note : mesh.notes) warn(file + ": " + note);
  const body::Part part{mesh.shape, density(body::volume(mesh.shape)), Eigen::Vector3d::Zero(),
                        Eigen::Matrix3d::Identity()};
  return {std::move(mesh), body::mass_properties({&part, 1})};
}

scene::Scene MeshOptions::scene(const std::string& file) const {
  return with_remedies_in_options([&] {
    return scene::mesh_scene(file, read_options(), [&](double volume) { return density(volume); });
  });
}

}  // namespace twrench::app

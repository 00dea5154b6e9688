#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/commands/commands.h"
#include "app/options/arguments.h"
#include "app/options/option_group.h"
#include "app/options/output_options.h"
#include "app/options/scene_options.h"
#include "app/reports/inertia_report.h"
#include "scene/limits.h"
#include "system/output.h"

namespace twrench::app {
namespace {

struct InertiaOptions {
  explicit InertiaOptions(CLI::App& command)
      : scene(command), output(command, system::inertia_output) {
    scene.add_inertia_option();
  }

  SceneOptions scene;
  OutputOptions output;
  std::string about;
  bool is_si = false;
};

std::optional<Turn> turn_of(const scene::Scene& scene) {
  const auto phase = motion::phase_of(scene::free_body(scene));
  if (!phase) return std::nullopt;
  return Turn{scene.motion.omega, *phase};
}

/// Reads the mesh or the scene that the user named, and adds its files to the inputs.
Described describe(const InertiaOptions& options, system::FileList& files) {
  const std::string& name = options.scene.sources().front();
  if (!mesh::is_mesh_name(name)) {
    options.scene.add_inputs(files);
    const scene::Scene scene = options.scene.scene();
    return {.name = options.scene.name_of(scene),
            .body = scene::mass_properties(scene.body),
            .turn = turn_of(scene),
            .is_rigid = scene.motion.is_rigid()};
  }
  files.add_input(name);
  options.scene.require_no_overrides(name);
  MeshBody mesh = options.scene.mesh_options().read(name);
  for (const auto& other : mesh.file.others) files.add_input(other);
  return {.name = std::filesystem::path(name).stem().string(),
          .body = mesh.properties,
          .mesh = std::move(mesh.file)};
}

Eigen::Vector3d point_of(const InertiaOptions& options) {
  const Eigen::Vector3d point = parse_vector(options.about, "--about");
  for (const double x : point) scene::limits::check(scene::limits::coordinate, "--about", x);
  return point;
}

}  // namespace

void add_inertia(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "inertia",
      "Print mass, centre of mass, inertia matrix, principal moments and axes, geometric phase");
  command->footer("Example: twrench inertia bracket.stl --unit mm --density 7.8");
  const auto options = std::make_shared<InertiaOptions>(*command);
  command->add_flag("--si", options->is_si, "print kg, m and kg m^2 instead of g, cm and g cm^2")
      ->group(heading(OptionGroup::output));
  command
      ->add_option("--about", options->about,
                   "print the inertia about this point too, in cm or, with --si, in m")
      ->type_name("X,Y,Z")
      ->group(heading(OptionGroup::output));
  command->callback([options] {
    system::FileList files = options->output.files();
    Described described = describe(*options, files);
    if (options->is_si) described.units = kilogram_metre;
    if (!options->about.empty()) described.about = point_of(*options);
    const system::OutputFile file = options->output.add_to(files);
    system::write_output(
        file, file.format().name == "text" ? inertia_text(described) : inertia_json(described));
  });
}

}  // namespace twrench::app

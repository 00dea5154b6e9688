#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/commands/commands.h"
#include "app/options/arguments.h"
#include "app/options/scene_options.h"
#include "app/terminal/output.h"
#include "base/enumeration.h"
#include "scene/prediction.h"
#include "system/file.h"
#include "text/escape.h"

namespace twrench::app {
namespace {

struct InertiaOptions {
  explicit InertiaOptions(CLI::App& command) : scene(command) { scene.add_inertia_option(); }

  SceneOptions scene;
  std::string format = "text";
  std::string output = "-";
};

std::string row(const auto& v) {
  return fmt::format("{:>25.17g}{:>25.17g}{:>25.17g}\n", v[0], v[1], v[2]);
}

std::string matrix(const Eigen::Matrix3d& m) {
  return "  " + row(m.row(0)) + "  " + row(m.row(1)) + "  " + row(m.row(2));
}

/// A line for each principal axis, that of the least moment first.
std::string predictions(const body::MassProperties& body) {
  std::string lines;
  for (int axis = 0; axis < 3; ++axis) {
    lines += "  " + scene::prediction({body.moments, body.axes}, axis, 1) + "\n";
  }
  return lines;
}

/// What is printed of a body.
struct Described {
  std::string name;
  body::MassProperties body;
  /// Its mesh, where it is one.
  std::optional<mesh::MeshFile> mesh = {};
};

std::string mesh_lines(const mesh::MeshFile& mesh) {
  return fmt::format(
      "triangles            {}\n"
      "open edges           {}\n"
      "volume               {:.17g} cm^3\n"
      "area                 {:.17g} cm^2\n",
      mesh.shape.surface->triangles.size(), mesh.open_edges, body::volume(mesh.shape), mesh.area);
}

std::string text(const Described& described) {
  const auto& [name, body, mesh] = described;
  const std::string mass =
      std::isnan(body.mass) ? "not given" : fmt::format("{:.17g} g", body.mass);
  return fmt::format(
      "{:<20} {}\n"
      "{}"
      "mass                 {}\n"
      "centre of mass, cm\n  {}"
      "inertia about it, body axes, g cm^2\n{}"
      "principal moments, g cm^2\n  {}"
      "principal axes as columns, in body axes\n{}"
      "a small tilt of its steady rotation\n{}",
      mesh ? "mesh" : "scene", text::escape(name), mesh ? mesh_lines(*mesh) : "", mass,
      row(body.centre_of_mass), matrix(body.inertia), row(body.moments), matrix(body.axes),
      predictions(body));
}

nlohmann::ordered_json numbers(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

nlohmann::ordered_json rows(const Eigen::Matrix3d& m) {
  return {numbers(m.row(0)), numbers(m.row(1)), numbers(m.row(2))};
}

/// Of a steady rotation at 1 rad/s about each principal axis, that of the least moment first.
nlohmann::ordered_json stability_json(const body::MassProperties& body) {
  auto list = nlohmann::ordered_json::array();
  for (int axis = 0; axis < 3; ++axis) {
    const motion::Stability stability = motion::stability(body.moments, axis, 1);
    nlohmann::ordered_json entry{{"axis", scene::axis_name(body.axes, axis)},
                                 {"kind", enumerator_name(stability.kind)},
                                 {"rate", stability.rate}};
    if (stability.kind == motion::Stability::Kind::unstable) {
      entry["doubling_time"] = stability.doubling_time();
    } else if (stability.kind == motion::Stability::Kind::stable) {
      entry["period"] = stability.period();
    }
    list.push_back(std::move(entry));
  }
  return list;
}

std::string json(const Described& described) {
  const auto& [name, body, mesh] = described;
  nlohmann::ordered_json document{{"scene", name}};
  document["mass"] = body.mass;  // NaN, if only moments are given, becomes null
  document["centre_of_mass"] = numbers(body.centre_of_mass);
  document["inertia"] = rows(body.inertia);
  document["principal_moments"] = numbers(body.moments);
  document["principal_axes"] = rows(body.axes);
  document["stability"] = stability_json(body);
  if (mesh) {
    document["triangles"] = mesh->shape.surface->triangles.size();
    document["open_edges"] = mesh->open_edges;
    document["volume"] = body::volume(mesh->shape);
    document["area"] = mesh->area;
  }
  return document.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

/// The mesh or the scene that is named.
Described describe(const InertiaOptions& options) {
  const std::string& name = options.scene.sources().front();
  if (!mesh::is_mesh_name(name)) {
    options.scene.require_not_input(options.output);
    const scene::Scene scene = options.scene.scene();
    return {scene.name, scene::mass_properties(scene.body)};
  }
  system::require_not_input(options.output, name);
  options.scene.require_no_overrides(name);
  MeshBody mesh = options.scene.mesh_options().read(name);
  for (const auto& other : mesh.file.others) system::require_not_input(options.output, other);
  return {std::filesystem::path(name).stem().string(), mesh.properties, std::move(mesh.file)};
}

}  // namespace

void add_inertia(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "inertia", "Print mass, centre of mass, inertia matrix, principal moments and axes");
  command->footer("Example: twrench inertia bracket.stl --unit mm --density 7.8");
  const auto options = std::make_shared<InertiaOptions>(*command);
  command->add_option("--format", options->format, "output format: text or json")
      ->check(one_of("--format", {"text", "json"}))
      ->type_name("FORMAT")
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "output file, or - for standard output")
      ->type_name("FILE")
      ->capture_default_str();
  command->callback([options] {
    const Described described = describe(*options);
    write_output(options->output, options->format == "text" ? text(described) : json(described));
  });
}

}  // namespace twrench::app

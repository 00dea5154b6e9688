#include <fmt/format.h>
#include <twrench/motion/exact.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>

#include "app/commands/commands.h"
#include "app/options/output_options.h"
#include "app/options/scene_options.h"
#include "base/enumeration.h"
#include "motion/phase.h"
#include "scene/prediction.h"
#include "system/file.h"
#include "system/output.h"
#include "text/escape.h"

namespace twrench::app {
namespace {

struct InertiaOptions {
  explicit InertiaOptions(CLI::App& command)
      : scene(command), output(command, system::inertia_output) {
    scene.add_inertia_option();
  }

  SceneOptions scene;
  OutputOptions output;
};

std::string row(const auto& v) { return fmt::format("{:>25}{:>25}{:>25}\n", v[0], v[1], v[2]); }

std::string matrix(const Eigen::Matrix3d& m) {
  return "  " + row(m.row(0)) + "  " + row(m.row(1)) + "  " + row(m.row(2));
}

bool has_unstable_axis(const body::MassProperties& body) {
  return motion::stability(body.moments, body::PrincipalAxes::intermediate, 1).kind ==
         motion::Stability::Kind::unstable;
}

/// The effect of a tilt, with a line per principal axis in ascending order of the moments. Empty
/// unless the body is rigid.
std::string predictions(const body::MassProperties& body, bool is_rigid) {
  if (!is_rigid) return {};
  std::string lines = "a small tilt of its steady rotation\n";
  for (const auto axis : body::PrincipalAxes::all) {
    lines += "  " + scene::prediction({body.moments, body.axes}, axis, 1) + "\n";
  }
  if (has_unstable_axis(body)) {
    lines += fmt::format("  a wheel along {} with more than {:.4g} g cm^2/s makes it stable\n",
                         scene::axis_name(body.axes, body::PrincipalAxes::intermediate),
                         motion::stabilizing_wheel(body.moments, 1));
  }
  return lines;
}

/// The rotation about L in one period of a scene's motion.
struct Turn {
  Eigen::Vector3d omega;  ///< At t = 0, in body axes, rad/s.
  motion::ExactMotion::Phase phase;
};

/// The body whose properties are printed.
struct Described {
  std::string name;
  body::MassProperties body;
  /// Its mesh, if it is one.
  std::optional<mesh::MeshFile> mesh = {};
  /// For a scene whose motion is periodic in the body.
  std::optional<Turn> turn = {};
  bool is_rigid = true;
};

std::optional<Turn> turn_of(const scene::Scene& scene) {
  const auto phase = motion::phase_of(scene::free_body(scene));
  if (!phase) return std::nullopt;
  return Turn{scene.motion.omega, *phase};
}

std::string angle_line(const char* name, double angle) {
  return fmt::format("  {:<18} {} rad, {:.6g} turns\n", name, angle,
                     angle / (2 * std::numbers::pi));
}

std::string turn_lines(const Turn& turn, bool is_rigid) {
  const auto& [omega, phase] = turn;
  return fmt::format(
             "rotation about L in one period of the momentum in the body, omega = ({:.6g}, {:.6g}, "
             "{:.6g}) rad/s\n",
             omega[0], omega[1], omega[2]) +
         fmt::format("  {:<18} {} s\n", "period T", phase.period) +
         angle_line("total", phase.total) +
         angle_line(is_rigid ? "dynamic, 2 E T/|L|" : "dynamic", phase.dynamic) +
         angle_line("geometric", phase.geometric());
}

std::string mesh_lines(const mesh::MeshFile& mesh) {
  return fmt::format(
      "triangles            {}\n"
      "open edges           {}\n"
      "volume               {} cm^3\n"
      "area                 {} cm^2\n",
      mesh.shape.surface->triangles.size(), mesh.open_edges, body::volume(mesh.shape), mesh.area);
}

std::string text(const Described& described) {
  const auto& [name, body, mesh, turn, is_rigid] = described;
  const std::string mass = std::isnan(body.mass) ? "not given" : fmt::format("{} g", body.mass);
  return fmt::format(
      "{:<20} {}\n"
      "{}"
      "mass                 {}\n"
      "centre of mass, cm\n  {}"
      "inertia about it, body axes, g cm^2\n{}"
      "principal moments, g cm^2\n  {}"
      "principal axes as columns, in body axes\n{}"
      "{}{}",
      mesh ? "mesh" : "scene", text::escape(name), mesh ? mesh_lines(*mesh) : "", mass,
      row(body.centre_of_mass), matrix(body.inertia), row(body.moments), matrix(body.axes),
      predictions(body, is_rigid), turn ? turn_lines(*turn, is_rigid) : "");
}

nlohmann::ordered_json numbers(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

nlohmann::ordered_json rows(const Eigen::Matrix3d& m) {
  return {numbers(m.row(0)), numbers(m.row(1)), numbers(m.row(2))};
}

/// The stability of a steady rotation at 1 rad/s about each principal axis, in ascending order of
/// the moments.
nlohmann::ordered_json stability_json(const body::MassProperties& body) {
  auto list = nlohmann::ordered_json::array();
  for (const auto axis : body::PrincipalAxes::all) {
    const motion::Stability stability = motion::stability(body.moments, axis, 1);
    nlohmann::ordered_json entry{{"axis", scene::axis_name(body.axes, axis)},
                                 {"kind", enumerator_name(stability.kind)},
                                 {"rate", stability.rate}};
    if (stability.kind == motion::Stability::Kind::unstable) {
      entry["doubling_time"] = stability.doubling_time();
      entry["stabilizing_wheel"] = motion::stabilizing_wheel(body.moments, 1);
    } else if (stability.kind == motion::Stability::Kind::stable) {
      entry["period"] = stability.period();
    }
    list.push_back(std::move(entry));
  }
  return list;
}

nlohmann::ordered_json turn_json(const Turn& turn) {
  return {{"omega", numbers(turn.omega)},
          {"period", turn.phase.period},
          {"total", turn.phase.total},
          {"dynamic", turn.phase.dynamic},
          {"geometric", turn.phase.geometric()}};
}

std::string json(const Described& described) {
  const auto& [name, body, mesh, turn, is_rigid] = described;
  nlohmann::ordered_json document{{"scene", name}};
  document["mass"] = body.mass;  // NaN, if only moments are given, becomes null
  document["centre_of_mass"] = numbers(body.centre_of_mass);
  document["inertia"] = rows(body.inertia);
  document["principal_moments"] = numbers(body.moments);
  document["principal_axes"] = rows(body.axes);
  if (is_rigid) document["stability"] = stability_json(body);
  if (turn) document["phase"] = turn_json(*turn);
  if (mesh) {
    document["triangles"] = mesh->shape.surface->triangles.size();
    document["open_edges"] = mesh->open_edges;
    document["volume"] = body::volume(mesh->shape);
    document["area"] = mesh->area;
  }
  return document.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
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

}  // namespace

void add_inertia(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "inertia",
      "Print mass, centre of mass, inertia matrix, principal moments and axes, geometric phase");
  command->footer("Example: twrench inertia bracket.stl --unit mm --density 7.8");
  const auto options = std::make_shared<InertiaOptions>(*command);
  command->callback([options] {
    system::FileList files = options->output.files();
    const Described described = describe(*options, files);
    const system::OutputFile file = options->output.add_to(files);
    system::write_output(file, file.format().name == "text" ? text(described) : json(described));
  });
}

}  // namespace twrench::app

#include <fmt/format.h>
#include <twrench/base/error.h>
#include <twrench/body/mass_properties.h>
#include <twrench/body/shape.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/stability.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include "app/commands/commands.h"
#include "app/commands/robot_inertia.h"
#include "app/options/arguments.h"
#include "app/options/command_line.h"
#include "app/options/scene_options.h"
#include "base/enumeration.h"
#include "mesh/mesh_file.h"
#include "motion/phase.h"
#include "scene/limits.h"
#include "scene/prediction.h"
#include "system/output.h"
#include "text/escape.h"

namespace twrench::app {
namespace {

/// The units of a report. The numbers are grams and centimetres per unit.
struct InertiaUnits {
  std::string_view mass, length;
  double grams, centimetres;
};

inline constexpr InertiaUnits gram_centimetre{"g", "cm", 1, 1}, kilogram_metre{"kg", "m", 1e3, 1e2};

/// The rotation about L in one period of a scene's motion.
struct Turn {
  Eigen::Vector3d omega;  ///< At t = 0, in body axes, rad/s.
  motion::ExactMotion::Phase phase;
};

/// The body whose properties are printed.
struct Described {
  /// "scene", "mesh" or "link".
  std::string_view kind;
  std::string name;
  body::MassProperties body;
  /// Its mesh, if it is one.
  std::optional<mesh::MeshFile> mesh = {};
  /// For a scene whose motion is periodic in the body.
  std::optional<Turn> turn = {};
  bool is_rigid = true;
  /// A point in the units of the report, about which the inertia is printed too.
  std::optional<Eigen::Vector3d> about = {};
  InertiaUnits units = gram_centimetre;
};

std::string row(const auto& v) { return fmt::format("{:>25}{:>25}{:>25}\n", v[0], v[1], v[2]); }

std::string matrix(const Eigen::Matrix3d& m) {
  return "  " + row(m.row(0)) + "  " + row(m.row(1)) + "  " + row(m.row(2));
}

/// Grams times the given power of centimetres in the unit of that quantity.
double grams_per(const InertiaUnits& units, int power) {
  return units.grams * std::pow(units.centimetres, power);
}

std::string inertia_unit(const InertiaUnits& units) {
  return fmt::format("{} {}^2", units.mass, units.length);
}

/// The inertia about the point in g cm^2, by the parallel-axis theorem.
Eigen::Matrix3d inertia_about(const Eigen::Vector3d& point, const Described& described) {
  const body::MassProperties& body = described.body;
  if (std::isnan(body.mass)) {
    throw InvalidArgument("--about", "needs the mass of the body, which is not given",
                          "name a scene with parts, or a mesh");
  }
  return body::inertia_about(body, point * described.units.centimetres);
}

bool has_unstable_axis(const body::MassProperties& body) {
  return motion::stability(body.moments, body::PrincipalAxes::intermediate, 1).kind ==
         motion::Stability::Kind::unstable;
}

/// The effect of a tilt, with a line per principal axis in ascending order of the moments. Empty
/// unless the body is rigid.
std::string predictions(const Described& described) {
  const body::MassProperties& body = described.body;
  if (!described.is_rigid) return {};
  std::string lines = "a small tilt of its steady rotation\n";
  for (const auto axis : body::PrincipalAxes::all) {
    lines += "  " + scene::prediction({body.moments, body.axes}, axis, 1) + "\n";
  }
  if (has_unstable_axis(body)) {
    lines += fmt::format("  a wheel along {} with more than {:.4g} {}/s makes it stable\n",
                         scene::axis_name(body.axes, body::PrincipalAxes::intermediate),
                         motion::stabilizing_wheel(body.moments, 1) / grams_per(described.units, 2),
                         inertia_unit(described.units));
  }
  return lines;
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

std::string mesh_lines(const mesh::MeshFile& mesh, const InertiaUnits& units) {
  return fmt::format(
      "triangles            {}\n"
      "open edges           {}\n"
      "volume               {} {}^3\n"
      "area                 {} {}^2\n",
      mesh.shape.surface->triangles.size(), mesh.open_edges,
      body::volume(mesh.shape) / std::pow(units.centimetres, 3), units.length,
      mesh.area / std::pow(units.centimetres, 2), units.length);
}

std::string about_lines(const Described& described) {
  if (!described.about) return {};
  const Eigen::Vector3d& point = *described.about;
  const Eigen::Matrix3d inertia = inertia_about(point, described) / grams_per(described.units, 2);
  return fmt::format("inertia about ({}, {}, {}) {}, body axes, {}\n{}", point[0], point[1],
                     point[2], described.units.length, inertia_unit(described.units),
                     matrix(inertia));
}

nlohmann::ordered_json numbers(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

nlohmann::ordered_json rows(const Eigen::Matrix3d& m) {
  return {numbers(m.row(0)), numbers(m.row(1)), numbers(m.row(2))};
}

/// The stability of a steady rotation at 1 rad/s about each principal axis, in ascending order of
/// the moments.
nlohmann::ordered_json stability_json(const body::MassProperties& body, double of_inertia) {
  auto list = nlohmann::ordered_json::array();
  for (const auto axis : body::PrincipalAxes::all) {
    const motion::Stability stability = motion::stability(body.moments, axis, 1);
    nlohmann::ordered_json entry{{"axis", scene::axis_name(body.axes, axis)},
                                 {"kind", enumerator_name(stability.kind)},
                                 {"rate", stability.rate}};
    if (stability.kind == motion::Stability::Kind::unstable) {
      entry["doubling_time"] = stability.doubling_time();
      entry["stabilizing_wheel"] = motion::stabilizing_wheel(body.moments, 1) / of_inertia;
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

/// The report as text, and as JSON. Throw InvalidArgument about --about if the mass is not given.
std::string inertia_text(const Described& described) {
  const auto& [kind, name, body, mesh, turn, is_rigid, about, units] = described;
  const std::string mass = std::isnan(body.mass)
                               ? "not given"
                               : fmt::format("{} {}", body.mass / units.grams, units.mass);
  const double of_inertia = grams_per(units, 2);
  const std::string unit = inertia_unit(units);
  return fmt::format(
      "{:<20} {}\n"
      "{}"
      "mass                 {}\n"
      "centre of mass, {}\n  {}"
      "inertia about it, body axes, {}\n{}{}"
      "principal moments, {}\n  {}"
      "principal axes as columns, in body axes\n{}"
      "{}{}",
      kind, text::escape(name), mesh ? mesh_lines(*mesh, units) : "", mass, units.length,
      row(body.centre_of_mass / units.centimetres), unit, matrix(body.inertia / of_inertia),
      about_lines(described), unit, row(body.moments / of_inertia), matrix(body.axes),
      predictions(described), turn ? turn_lines(*turn, is_rigid) : "");
}

std::string inertia_json(const Described& described) {
  const auto& [kind, name, body, mesh, turn, is_rigid, about, units] = described;
  const double of_inertia = grams_per(units, 2);
  nlohmann::ordered_json document{{"scene", name}};
  document["units"] = {
      {"mass", units.mass}, {"length", units.length}, {"inertia", inertia_unit(units)}};
  document["mass"] = body.mass / units.grams;  // NaN, if only moments are given, becomes null
  document["centre_of_mass"] = numbers(body.centre_of_mass / units.centimetres);
  document["inertia"] = rows(body.inertia / of_inertia);
  if (about) {
    document["about"] = {{"point", numbers(*about)},
                         {"inertia", rows(inertia_about(*about, described) / of_inertia)}};
  }
  document["principal_moments"] = numbers(body.moments / of_inertia);
  document["principal_axes"] = rows(body.axes);
  if (is_rigid) document["stability"] = stability_json(body, of_inertia);
  if (turn) document["phase"] = turn_json(*turn);
  if (mesh) {
    document["triangles"] = mesh->shape.surface->triangles.size();
    document["open_edges"] = mesh->open_edges;
    document["volume"] = body::volume(mesh->shape) / std::pow(units.centimetres, 3);
    document["area"] = mesh->area / std::pow(units.centimetres, 2);
  }
  return document.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

struct InertiaOptions {
  explicit InertiaOptions(CLI::App& command)
      : scene(command), output(command, system::inertia_output) {
    scene.add_inertia_option();
    add_repair_options(command, repair);
  }

  SceneOptions scene;
  RepairOptions repair;
  OutputOptions output;
  std::string about;
  bool is_si = false;
};

std::optional<Turn> turn_of(const scene::Scene& scene) {
  if (scene.motion.recording_file) return std::nullopt;  // it has no initial angular velocity
  const auto phase = motion::phase_of(scene::free_body(scene));
  if (!phase) return std::nullopt;
  return Turn{scene.motion.omega, *phase};
}

/// The link of a robot that the user named.
Described describe_link(const InertiaOptions& options, system::FileList& files) {
  const std::string& file = options.scene.sources().front();
  const RobotOptions& robot_options = options.scene.robot_options();
  options.scene.require_no_overrides(file);
  options.scene.mesh_options().require_none();
  const robot::JudgedRobot judged = robot_options.read(file);
  files.add_input(file);
  for (const std::filesystem::path& other : judged.files) files.add_input(other);
  const robot::Diagnosis& link = judged.diagnoses[robot_options.index(judged.robot)];
  if (link.verdict == robot::Verdict::unstated || !(link.moments[0] > 0.0)) {
    throw InvalidArgument(fmt::format("{}: link '{}'", file, robot_options.link()),
                          "it has no mass properties that a body can have",
                          "see the report on all links: twrench inertia FILE");
  }
  constexpr double grams = kilogram_metre.grams, cm = kilogram_metre.centimetres;
  const Eigen::Matrix3d inertia = grams * cm * cm * link.body.inertia;
  const body::PrincipalAxes principal = body::principal_axes((inertia + inertia.transpose()) / 2);
  return {.kind = "link",
          .name = robot_options.link(),
          .body = {grams * link.body.mass, cm * link.body.centre, inertia, principal.moments,
                   principal.axes}};
}

/// Reads the mesh, the link or the scene that the user named, and adds its files to the inputs.
Described describe(const InertiaOptions& options, system::FileList& files) {
  const std::string& name = options.scene.sources().front();
  if (robot::is_robot_name(name)) return describe_link(options, files);
  if (!mesh::is_mesh_name(name)) {
    options.scene.add_inputs(files);
    const scene::Scene scene = options.scene.scene();
    return {.kind = "scene",
            .name = options.scene.name_of(scene),
            .body = scene::mass_properties(scene.body),
            .turn = turn_of(scene),
            .is_rigid = scene.motion.is_rigid()};
  }
  files.add_input(name);
  options.scene.require_no_overrides(name);
  options.scene.robot_options().require_none();
  MeshBody mesh = options.scene.mesh_options().read(name);
  for (const auto& other : mesh.file.others) files.add_input(other);
  return {.kind = "mesh",
          .name = std::filesystem::path(name).stem().string(),
          .body = mesh.properties,
          .mesh = std::move(mesh.file)};
}

Eigen::Vector3d point_of(const InertiaOptions& options) {
  const Eigen::Vector3d point = parse_vector(options.about, "--about");
  for (const double x : point) scene::limits::check(scene::limits::coordinate, "--about", x);
  return point;
}

/// Throws InvalidArgument about an option that is only for a whole robot.
void require_one_body(const InertiaOptions& options, const system::OutputFile& file) {
  const char* option = !options.repair.fixed_file.empty() ? "--fix"
                       : !options.repair.page.empty()     ? "--report"
                       : options.repair.from_mesh         ? "--from-mesh"
                       : file.format().name == "junit"    ? "--format junit"
                                                          : nullptr;
  if (option == nullptr) return;
  throw InvalidArgument(option, "is for the links of a robot, and this is a single body",
                        "name a file in URDF, SDF or MJCF, without --link");
}

/// Prints a single body.
void print_body(const InertiaOptions& options) {
  system::FileList files = options.output.files();
  Described described = describe(options, files);
  if (options.is_si) described.units = kilogram_metre;
  if (!options.about.empty()) described.about = point_of(options);
  const system::OutputFile file = options.output.add_to(files);
  require_one_body(options, file);
  system::write_output(
      file, file.format().name == "text" ? inertia_text(described) : inertia_json(described));
}

/// Whether the user named a robot, and none of its links.
bool is_whole_robot(const InertiaOptions& options) {
  return robot::is_robot_name(options.scene.sources().front()) &&
         options.scene.robot_options().link().empty();
}

}  // namespace

void add_inertia(CLI::App& app, ExitCode& code) {
  CLI::App* command = app.add_subcommand(
      "inertia",
      "Print mass, centre of mass, inertia matrix, principal moments and axes, geometric phase");
  command->footer(
      "Example: twrench inertia bracket.stl --unit mm --density 7.8\n"
      "Example: twrench inertia robot.urdf --fix repaired.urdf\n"
      "Exit code 1: a link of the robot has mass properties that no body has.");
  const auto options = std::make_shared<InertiaOptions>(*command);
  command->add_flag("--si", options->is_si, "print kg, m and kg m^2 instead of g, cm and g cm^2")
      ->group(heading(OptionGroup::output));
  command
      ->add_option("--about", options->about,
                   "print the inertia about this point too, in cm or, with --si, in m")
      ->type_name("X,Y,Z")
      ->group(heading(OptionGroup::output));
  command->callback([options, &code] {
    if (!is_whole_robot(*options)) return print_body(*options);
    options->scene.require_no_overrides(options->scene.sources().front());
    options->scene.mesh_options().require_none();
    code = judge_robot(options->scene.sources().front(), options->scene.robot_options(),
                       options->repair, options->output);
  });
}

}  // namespace twrench::app

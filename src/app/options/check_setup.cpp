#include "app/options/check_setup.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <span>
#include <vector>

#include "app/options/arguments.h"
#include "app/options/option_group.h"
#include "app/options/scene_options.h"
#include "base/enumeration.h"
#include "recording/conventions/units.h"
#include "scene/interior.h"
#include "scene/limits.h"
#include "scene/mesh_scene.h"
#include "scene/scene.h"
#include "system/file.h"

namespace twrench::app {
namespace {

template <typename Name>
void add_unit_option(CLI::App& command, const std::string& option, std::string& text,
                     const std::string& description, std::span<const Name> units,
                     const std::string& otherwise) {
  std::vector<std::string> names;
  for (const Name& unit : units) names.emplace_back(unit.option);
  command.add_option(option, text, fmt::format("{}: {}", description, fmt::join(names, ", ")))
      ->check(one_of(option, names))
      ->type_name("UNIT")
      ->default_str(otherwise)
      ->group(heading(OptionGroup::data));
}

/// The unit of a mesh does not matter, because only the ratios of the moments do.
scene::Scene mesh_scene(const std::string& file) try {
  return scene::mesh_scene(file, {.scale = 1.0}, [](double) { return 1.0; });
} catch (const mesh::MeshError& error) {
  throw error.with_remedy(
      "give its moments by --inertia, as twrench inertia prints them with --weld or --shell");
}

}  // namespace

void CheckSetup::add_options(CLI::App& command) {
  command.add_option("--inertia", inertia_, fmt::format("{}, in any unit", inertia_help))
      ->type_name(inertia_placeholder)
      ->group(heading(OptionGroup::body));
  command.add_option("--scene", scene_name_, "take the body of this scene or mesh instead")
      ->type_name("SCENE")
      ->group(heading(OptionGroup::body));
  command
      .add_option("--case", case_name_,
                  "take the body and the initial rates of this published case instead")
      ->type_name("NAME")
      ->group(heading(OptionGroup::body));
  command.add_option("--omega", omega_, "angular velocity at t = 0, body axes, rad/s")
      ->type_name("X,Y,Z")
      ->default_str("the first row's, at its time; fitted to a file without rates")
      ->group(heading(OptionGroup::motion));
  command
      .add_option("--omega-at", omega_at_,
                  "the time at which --omega or --case holds, s, on the file's clock: a number, or "
                  "first, that "
                  "of the first row")
      ->type_name("T")
      ->capture_default_str()
      ->group(heading(OptionGroup::motion));
  command.add_flag("--fit", fit_, "fit the initial state to all rows by least squares")
      ->group(heading(OptionGroup::motion));
  command
      .add_option(
          "--frame", frame_,
          "what the file's space frame is found from: first, the first row, or momentum, the "
          "mean direction of L")
      ->check(one_of("--frame", enumerator_names<check::FrameSource>()))
      ->type_name("FROM")
      ->capture_default_str()
      ->group(heading(OptionGroup::data));
  command
      .add_option(
          "--columns", texts_.columns,
          "the file's columns for t, wx wy wz, lx ly lz, x11 to x33, qw qx qy qz, yaw pitch roll, "
          "rvx rvy rvz, axisx axisy axisz angle, mrpx mrpy mrpz, gibbsx gibbsy gibbsz")
      ->type_name("t=NAME,wx=NAME,...")
      ->default_str("by their names")
      ->group(heading(OptionGroup::data));
  add_unit_option(command, "--time-unit", texts_.time_unit, "unit of times",
                  recording::time_units(), "what the file says, else s");
  add_unit_option(command, "--units", texts_.units,
                  "unit of angles and, a second, of rates; rpm of rates alone",
                  recording::rate_units(), "what the file says, else rad");
  add_unit_option(command, "--angle-units", texts_.angle_units, "unit of Euler angles alone",
                  recording::angle_units(), "what the file says, else that of --units");
  command
      .add_option("--sequence", texts_.sequence,
                  "axes of Euler angles in the order of the rotations")
      ->type_name("AXES")
      ->group(heading(OptionGroup::data));
  command
      .add_flag("--inverse", texts_.inverse, "the attitude is body from space, not space from body")
      ->group(heading(OptionGroup::data));
  command.add_option("--rates", texts_.rates, "the axes of the rates: body or space")
      ->check(one_of("--rates", {"body", "space"}))
      ->type_name("AXES")
      ->capture_default_str()
      ->group(heading(OptionGroup::data));
  command
      .add_option("--axes", texts_.axes,
                  "the body's axes along which the file's x, y and z point, such as x,-z,y")
      ->type_name("X,Y,Z")
      ->default_str("x,y,z")
      ->group(heading(OptionGroup::data));
  command
      .add_option(
          "--offset", offset_,
          "the attitude is that of a part: the quaternion, scalar first, that takes its axes to "
          "the body's")
      ->type_name("W,X,Y,Z")
      ->group(heading(OptionGroup::data));
}

const scene::Scene& CheckSetup::scene() const {
  if (!scene_) {
    scene_ =
        mesh::is_mesh_name(scene_name_) ? mesh_scene(scene_name_) : scene::load_scene(scene_name_);
  }
  return *scene_;
}

Eigen::Matrix3d CheckSetup::inertia() const {
  if (!scene_name_.empty() && !inertia_.empty()) {
    throw InvalidArgument("--scene", "--inertia gives the body already", "leave out one of them");
  }
  if (!scene_name_.empty()) {
    scene::require_rigid(scene(), "a check");
    return scene::mass_properties(scene().body).inertia;
  }
  if (inertia_.empty()) {
    throw InvalidArgument(
        "check", "the body is not given",
        "give its principal moments with --inertia A,B,C, in any unit, its inertia matrix with "
        "--inertia Ixx,Iyy,Izz,Ixy,Ixz,Iyz, or --scene or --case");
  }
  Eigen::Matrix3d inertia = parse_inertia(inertia_, "--inertia");
  warn_of_unreal_moments("--inertia", inertia);
  return inertia;
}

std::optional<cases::Case> CheckSetup::published_case() const {
  if (case_name_.empty()) return std::nullopt;
  for (const auto& [value, option] :
       {std::pair(&inertia_, "--inertia"), std::pair(&scene_name_, "--scene"),
        std::pair(&omega_, "--omega")}) {
    if (value->empty()) continue;
    throw InvalidArgument(
        "--case", fmt::format("it gives the body and the initial rates, and {} does too", option),
        "leave out one of them");
  }
  return cases::load_case(case_name_, "--case");
}

check::Problem CheckSetup::problem() const {
  const std::optional<cases::Case> published = published_case();
  check::Problem problem{.inertia = published ? published->moments.asDiagonal().toDenseMatrix()
                                              : inertia()};
  if (published) {
    problem.omega = published->omega;
  } else if (!omega_.empty()) {
    problem.omega = scene::limits::check_omega("--omega", parse_vector(omega_, "--omega"));
  }
  problem.omega_time.reset();
  if (omega_at_ != "first") {
    problem.omega_time = parse_number(omega_at_, "--omega-at", scene::limits::coordinate);
  }
  problem.fit = fit_;
  problem.frame = find_enumerator<check::FrameSource>(frame_, "--frame");
  return problem;
}

recording::Convention CheckSetup::convention() const {
  recording::Convention given = check::parse_convention(texts_);
  if (!offset_.empty()) {
    given.offset = scene::limits::check_rotation("--offset", parse_quaternion(offset_, "--offset"));
  }
  return given;
}

void CheckSetup::add_inputs(system::FileList& files) const {
  if (scene_name_.empty()) return;
  files.add_input(scene_name_);
  for (const std::filesystem::path& file : scene::input_files(scene())) files.add_input(file);
}

}  // namespace twrench::app

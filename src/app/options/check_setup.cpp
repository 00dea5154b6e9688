#include "app/options/check_setup.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "app/options/arguments.h"
#include "app/options/convention_options.h"
#include "app/options/scene_options.h"
#include "base/enumeration.h"
#include "check/conventions/units.h"
#include "check/hypotheses/hypotheses.h"
#include "check/hypotheses/readings.h"
#include "check/reading/columns.h"
#include "check/reading/open_conventions.h"
#include "scene/limits.h"
#include "scene/mesh_scene.h"
#include "scene/scene.h"
#include "system/file.h"
#include "table/reader.h"

namespace twrench::app {
namespace {

/// The components of the quaternion in the order of the file's columns: "xyzw".
std::string component_order(const table::Header& header, const check::Convention& convention) {
  std::vector<std::pair<std::size_t, char>> places;
  for (const char component : {'w', 'x', 'y', 'z'}) {
    const auto column = convention.columns.find(std::string("q") + component);
    if (column == convention.columns.end()) return {};
    places.emplace_back(check::find_column(header, column->first, column->second), component);
  }
  std::ranges::sort(places);
  std::string order;
  for (const auto& [place, component] : places) order += component;
  return order;
}

/// "these quaternions fit as xyzw, body from space".
std::string fit_text(const table::Header& header, const check::Convention& convention) {
  const char* frames = convention.inverse ? "body from space" : "space from body";
  switch (check::attitude_form(convention)) {
    case check::AttitudeForm::quaternion:
      return fmt::format("these quaternions fit as {}, {}", component_order(header, convention),
                         frames);
    case check::AttitudeForm::euler:
      return fmt::format("these angles fit in the sequence {}, {}", convention.sequence, frames);
    case check::AttitudeForm::matrix:
      return fmt::format("these matrices fit as {}", frames);
    case check::AttitudeForm::none:
      break;
  }
  return "only one of them fits the physics";
}

/// The options that choose `one` of the open conventions: for that in which they differ.
std::string choice_text(const check::Convention& said, const std::vector<check::Convention>& open,
                        const check::Convention& one) {
  check::Convention before = one;
  const auto differ = [&](auto aspect) {
    return std::ranges::any_of(
        open, [&](const check::Convention& other) { return other.*aspect != one.*aspect; });
  };
  const auto take_back = [&](auto aspect) {
    if (differ(aspect)) before.*aspect = said.*aspect;
  };
  take_back(&check::Convention::columns);
  take_back(&check::Convention::time_unit);
  take_back(&check::Convention::rate_unit);
  take_back(&check::Convention::angle_unit);
  take_back(&check::Convention::sequence);
  take_back(&check::Convention::inverse);
  take_back(&check::Convention::rates_in_space);
  return option_text(before, one);
}

InvalidArgument ambiguous(const table::Header& header, const check::Convention& said,
                          const std::vector<check::Convention>& open,
                          const std::optional<check::Reading>& fitting) {
  const std::string why = fmt::format("its columns can be read in {} ways", open.size());
  if (fitting) {
    return {header.file, why,
            fmt::format("{}: add {}", fit_text(header, fitting->convention),
                        choice_text(said, open, fitting->convention))};
  }
  constexpr std::size_t most = 8;
  std::vector<std::string> ways;
  for (const check::Convention& convention : open) {
    if (ways.size() < most) ways.push_back(choice_text(said, open, convention));
  }
  return {
      header.file, why,
      fmt::format("say which: {}{}", fmt::join(ways, "; or "), open.size() > most ? " ..." : "")};
}

template <typename Name>
void add_unit_option(CLI::App& command, const std::string& option, std::string& text,
                     const std::string& description, std::span<const Name> units,
                     const std::string& otherwise) {
  std::vector<std::string> names;
  for (const Name& unit : units) names.emplace_back(unit.option);
  command.add_option(option, text, fmt::format("{}: {}", description, fmt::join(names, ", ")))
      ->check(one_of(option, names))
      ->type_name("UNIT")
      ->default_str(otherwise);
}

/// The unit that an option names; nothing where it was not given.
template <typename Name>
auto unit_named(std::span<const Name> units, const std::string& text) {
  std::optional<decltype(Name::unit)> found;
  for (const Name& unit : units) {
    if (unit.option == text) found = unit.unit;
  }
  return found;
}

/// Throws InvalidArgument unless the four numbers are those of a rotation.
Eigen::Quaterniond parse_rotation(const std::string& text, const std::string& option) {
  const std::vector<double> q = parse_numbers(text, option);
  if (q.size() != 4) {
    throw InvalidArgument(option, fmt::format("has {} numbers", q.size()),
                          "give the four of a quaternion, the scalar first");
  }
  Eigen::Quaterniond rotation(q[0], q[1], q[2], q[3]);
  constexpr double most = 0.1;  // as of the quaternions of a file
  if (!(std::abs(rotation.norm() - 1) <= most)) {
    throw InvalidArgument(option, fmt::format("has the length {:.6g}", rotation.norm()),
                          "a quaternion of a rotation has the length 1");
  }
  rotation.normalize();
  return rotation;
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
      ->type_name(inertia_placeholder);
  command.add_option("--scene", scene_name_, "take the body of this scene or mesh instead")
      ->type_name("SCENE");
  command
      .add_option("--case", case_name_,
                  "take the body and the initial rates of this published case instead")
      ->type_name("NAME");
  command.add_option("--omega", omega_, "angular velocity at t = 0, body axes, rad/s")
      ->type_name("X,Y,Z")
      ->default_str("the first row's, at its time");
  command
      .add_option("--omega-at", omega_at_,
                  "the time at which --omega or --case holds, s, on the file's clock: a number, or "
                  "first, that "
                  "of the first row")
      ->type_name("T")
      ->capture_default_str();
  command.add_flag("--fit", fit_, "fit the initial state to all rows by least squares");
  command
      .add_option(
          "--frame", frame_,
          "what the file's space frame is found from: first, the first row, or momentum, the "
          "mean direction of L")
      ->check(one_of("--frame", enumerator_names<check::FrameFrom>()))
      ->type_name("FROM")
      ->capture_default_str();
  command
      .add_option("--columns", columns_,
                  "the file's columns for t, wx wy wz, x11 to x33, qw qx qy qz, yaw pitch roll")
      ->type_name("t=NAME,wx=NAME,...")
      ->default_str("by their names");
  add_unit_option(command, "--time-unit", time_unit_, "unit of times", check::time_units(),
                  "what the file says, else s");
  add_unit_option(command, "--units", units_,
                  "unit of angles and, a second, of rates; rpm of rates alone", check::rate_units(),
                  "what the file says, else rad");
  add_unit_option(command, "--angle-units", angle_units_, "unit of Euler angles alone",
                  check::angle_units(), "what the file says, else that of --units");
  command.add_option("--sequence", sequence_, "axes of Euler angles in the order of the rotations")
      ->type_name("AXES");
  command.add_flag("--inverse", inverse_, "the attitude is body from space, not space from body");
  command.add_option("--rates", rates_, "the axes of the rates: body or space")
      ->check(one_of("--rates", {"body", "space"}))
      ->type_name("AXES")
      ->capture_default_str();
  command
      .add_option("--axes", axes_,
                  "the body's axes along which the file's x, y and z point, such as x,-z,y")
      ->type_name("X,Y,Z")
      ->default_str("x,y,z");
  command
      .add_option(
          "--offset", offset_,
          "the attitude is that of a part: the quaternion, scalar first, that takes its axes to "
          "the body's")
      ->type_name("W,X,Y,Z");
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
  if (!scene_name_.empty()) return scene::mass_properties(scene().body).inertia;
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
  problem.frame = find_enumerator<check::FrameFrom>(frame_, "--frame");
  return problem;
}

check::Convention CheckSetup::said() const {
  check::Convention said;
  if (!columns_.empty()) said.columns = check::parse_columns(columns_, "--columns");
  said.time_unit = unit_named(check::time_units(), time_unit_);
  said.rate_unit = unit_named(check::rate_units(), units_);
  said.angle_unit = unit_named(check::angle_units(), angle_units_);
  if (!sequence_.empty()) said.sequence = check::parse_sequence(sequence_, "--sequence");
  said.inverse = inverse_;
  said.rates_in_space = rates_ == "space";
  if (!axes_.empty()) said.axes = check::parse_body_axes(axes_, "--axes");
  if (!offset_.empty()) said.offset = parse_rotation(offset_, "--offset");
  return said;
}

check::Convention CheckSetup::convention(const std::string& file,
                                         const check::Problem& problem) const {
  const check::Convention said = this->said();
  const table::Header header = table::open_table(file)->header();
  const std::vector<check::Convention> open = check::conventions(header, said);
  if (open.size() == 1) return open.front();
  std::optional<check::Reading> fitting =
      check::only_fitting(check::readings(file, problem.inertia, open));
  // Perhaps none of them fits, but one that no name suggests does.
  if (!fitting) {
    const check::Alternatives other = check::alternatives(file, problem, open.front());
    if (other.fitting.size() == 1) fitting = other.fitting.front();
  }
  throw ambiguous(header, said, open, fitting);
}

void CheckSetup::require_not_input(const std::filesystem::path& output) const {
  if (scene_name_.empty()) return;
  system::require_not_input(output, scene_name_);
  for (const std::filesystem::path& file : scene::input_files(scene())) {
    system::require_not_input(output, file);
  }
}

}  // namespace twrench::app

#include "app/options/check_setup.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/options/arguments.h"
#include "app/options/command_line.h"
#include "app/options/scene_options.h"
#include "app/terminal/message.h"
#include "base/enumeration.h"
#include "scene/interior.h"
#include "scene/limits.h"
#include "scene/mesh_scene.h"
#include "scene/scene.h"
#include "system/file.h"

namespace twrench::app {
namespace {

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
  command
      .add_flag("--fit", fit_,
                "fit the initial state to all rows by least squares; --fit inertia also finds the "
                "ratios of the moments")
      ->check(one_of("--fit", {"true", "false", "inertia"}))
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
  extract_.add_to(command);
  convention_.add_to(command);
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
        "--inertia Ixx,Iyy,Izz,Ixy,Ixz,Iyz, or --scene or --case; or find them: --fit inertia");
  }
  Eigen::Matrix3d inertia = parse_inertia(inertia_, "--inertia");
  warn_of_unreal_moments("--inertia", inertia);
  return inertia;
}

bool CheckSetup::fits_inertia() const {
  if (fit_ != "inertia") return false;
  for (const auto& [value, option] :
       {std::pair(&inertia_, "--inertia"), std::pair(&scene_name_, "--scene"),
        std::pair(&case_name_, "--case")}) {
    if (value->empty()) continue;
    throw InvalidArgument("--fit inertia",
                          fmt::format("it finds the body, and {} gives one", option),
                          "leave out one of them");
  }
  return true;
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
  check::Problem problem{.fit = fit_ == "true", .fits_inertia = fits_inertia()};
  if (!problem.fits_inertia) {
    problem.inertia = published ? published->moments.asDiagonal().toDenseMatrix() : inertia();
  }
  if (published) {
    problem.omega = published->omega;
  } else if (!omega_.empty()) {
    problem.omega = scene::limits::check_omega("--omega", parse_vector(omega_, "--omega"));
  }
  problem.omega_time.reset();
  if (omega_at_ != "first") {
    problem.omega_time = parse_number(omega_at_, "--omega-at", scene::limits::coordinate);
  }
  problem.frame = find_enumerator<check::FrameSource>(frame_, "--frame");
  return problem;
}

void CheckSetup::add_inputs(system::FileList& files) const {
  if (scene_name_.empty()) return;
  files.add_input(scene_name_);
  for (const std::filesystem::path& file : scene::input_files(scene())) files.add_input(file);
}

}  // namespace twrench::app

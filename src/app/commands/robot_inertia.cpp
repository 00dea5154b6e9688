#include "app/commands/robot_inertia.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "app/options/command_line.h"
#include "app/terminal/message.h"
#include "base/enumeration.h"
#include "base/words.h"
#include "film/page_pictures.h"
#include "robot/report.h"
#include "scene/limits.h"
#include "scene/link_scene.h"
#include "scene/mesh_scene.h"
#include "system/output.h"

namespace twrench::app {
namespace {

std::string report(std::string_view format, const robot::JudgedRobot& judged) {
  if (format == "json") return robot::robot_json(judged, option_text);
  return format == "junit" ? robot::robot_junit(judged) : robot::robot_text(judged);
}

/// A scene of a link with its ellipsoid of equal inertia, and nothing else.
scene::Scene picture_of(const robot::JudgedRobot& judged, std::size_t link,
                        const robot::LinkMass& mass) {
  scene::Scene scene =
      scene::body_scene(judged.robot.links[link].name, scene::link_body(judged, link, mass));
  scene.overlay.show = {scene::Feature::inertia, scene::Feature::axes};
  // The same before and after the repair.
  scene.camera.azimuth = 0.6, scene.camera.elevation = 0.35;
  return scene;
}

/// Whether a link with this inertia can be drawn: a scene can have its moments, and beside an
/// ellipsoid that is much larger than the link, it would be a dot.
bool is_drawable(const robot::JudgedRobot& judged, std::size_t link, const robot::LinkMass& mass) {
  const Eigen::Vector3d moments = robot::principal_moments(mass.inertia);
  constexpr double g_cm2 = 1e-7;  // kg m^2
  const bool is_body = mass.mass > 0.0 && moments[0] >= g_cm2 * scene::limits::moment.low &&
                       moments[2] <= g_cm2 * scene::limits::moment.high;
  if (!is_body) return false;
  const robot::LinkGeometry& geometry = judged.geometries[link];
  double size = 0.0;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(i);
    size = std::max(size, geometry.extent(axis) + geometry.extent(-axis));
  }
  constexpr double largest = 5.0;
  return geometry.parts().empty() || std::sqrt(moments[2] / mass.mass) < largest * size;
}

/// The pictures of the links that are not good, before and after the repair.
std::map<std::size_t, robot::LinkPictures> pictures_of(const robot::JudgedRobot& judged,
                                                       const robot::Repair& repair) {
  std::vector<scene::Scene> scenes;
  std::vector<std::pair<std::size_t, std::string robot::LinkPictures::*>> places;
  const auto add = [&](std::size_t link, const robot::LinkMass& mass,
                       std::string robot::LinkPictures::*place) {
    if (!is_drawable(judged, link, mass)) return;
    scenes.push_back(picture_of(judged, link, mass));
    places.emplace_back(link, place);
  };
  for (std::size_t i = 0; i < judged.diagnoses.size(); ++i) {
    const robot::Diagnosis& diagnosis = judged.diagnoses[i];
    if (!diagnosis.faults.empty() || !diagnosis.mistakes.empty())
      add(i, diagnosis.body, &robot::LinkPictures::before);
  }
  for (const robot::Change& change : repair.changes)
    add(change.index, change.after, &robot::LinkPictures::after);
  std::map<std::size_t, robot::LinkPictures> result;
  if (scenes.empty()) return result;
  const std::vector<std::string> pictures = film::still_pictures(scenes, {});
  for (std::size_t i = 0; i < places.size(); ++i)
    result[places[i].first].*places[i].second = pictures[i];
  return result;
}

}  // namespace

void add_repair_options(CLI::App& command, RepairOptions& options) {
  command
      .add_option(
          "--fix", options.fixed_file,
          "of a robot description: write it with repaired numbers, everything else byte for "
          "byte the same")
      ->type_name("FILE")
      ->group(heading(OptionGroup::output));
  command
      .add_option("--report", options.page,
                  "of a robot description: a page, .html, with pictures of the links that are not "
                  "good, before and after the repair")
      ->type_name("FILE")
      ->group(heading(OptionGroup::output));
  command
      .add_flag("--from-mesh", options.from_mesh,
                "with --fix or --report: give links that no mistake explains the moments of their "
                "geometry with "
                "uniform density")
      ->group(heading(OptionGroup::output));
}

ExitCode judge_robot(const std::string& file, const RobotOptions& robot_options,
                     const RepairOptions& repair_options, const OutputOptions& output) {
  if (repair_options.from_mesh && repair_options.fixed_file.empty() &&
      repair_options.page.empty()) {
    throw InvalidArgument("--from-mesh", "it chooses the kind of repair, and nothing is repaired",
                          "add --fix FILE or --report FILE");
  }
  if (repair_options.fixed_file == "-" && output.path() == "-") {
    throw InvalidArgument("--fix -", "standard output is used for the results",
                          "name a file, or give --output FILE");
  }
  const robot::JudgedRobot judged = robot_options.read(file);
  system::FileList files = output.files();
  files.add_input(file);
  for (const std::filesystem::path& other : judged.files) files.add_input(other);
  const system::OutputFile report_file = output.add_to(files, system::robot_output);
  std::optional<system::OutputFile> fixed_file;
  if (!repair_options.fixed_file.empty())
    fixed_file = files.add_output(system::robot_file, repair_options.fixed_file,
                                  enumerator_name(judged.robot.format));
  std::optional<system::OutputFile> page;
  if (!repair_options.page.empty())
    page = files.add_output(system::robot_page, repair_options.page);
  for (const std::string& note : judged.notes) warn(with_arguments(note, option_text));
  robot::Repair repair;
  if (page || fixed_file) repair = robot::repair(judged, repair_options.from_mesh);
  if (page) {
    system::write_output(*page,
                         robot_html(judged, repair, pictures_of(judged, repair), option_text));
  }
  if (fixed_file) {
    system::write_output(*fixed_file, repair.text);
    write_message(robot::repair_text(repair, option_text));
    say("twrench: inertia: {} links repaired, {} not; wrote {}\n", repair.changes.size(),
        repair.unrepaired.size(), fixed_file->path().string());
  }
  system::write_output(report_file, report(report_file.format().name, judged));
  return robot::count(judged, robot::Verdict::impossible) > 0 ? ExitCode::negative : ExitCode::done;
}

}  // namespace twrench::app

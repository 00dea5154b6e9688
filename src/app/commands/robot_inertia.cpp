#include "app/commands/robot_inertia.h"

#include <CLI/CLI.hpp>
#include <optional>

#include "app/options/command_line.h"
#include "app/terminal/message.h"
#include "base/enumeration.h"
#include "film/robot_pictures.h"
#include "robot/report.h"
#include "system/output.h"

namespace twrench::app {
namespace {

std::string report(std::string_view format, const robot::JudgedRobot& judged) {
  if (format == "json") return robot::robot_json(judged, option_text);
  return format == "junit" ? robot::robot_junit(judged) : robot::robot_text(judged);
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
  warn_of_notes(judged);
  robot::Repair repair;
  if (page || fixed_file) repair = robot::repair(judged, repair_options.from_mesh);
  if (page) {
    system::write_output(
        *page, robot_html(judged, repair, film::robot_pictures(judged, repair, {}), option_text));
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

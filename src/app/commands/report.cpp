#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/commands/commands.h"
#include "app/options/report_commands.h"
#include "app/options/scene_options.h"
#include "app/reports/page_html.h"
#include "app/terminal/output.h"
#include "app/terminal/version.h"
#include "plot/gnuplot.h"
#include "report/html.h"
#include "report/markdown.h"
#include "report/results.h"
#include "text/escape.h"

namespace twrench::app {
namespace {

const std::vector<std::string> three_experiments{"dzhanibekov", "stable-y", "stable-z"};

struct ReportOptions {
  explicit ReportOptions(CLI::App& app)
      : command(app), scenes(app, SceneOptions::Count::several, three_experiments) {
    scenes.add_motion_options();
  }

  CLI::App& command;
  SceneOptions scenes;
  std::string output, author, date;
  bool is_static = false;

  /// Whether it is the report of the course: on its experiments, unchanged.
  bool solves_tasks() const {
    return command.count("SCENE") + command.count("--omega") + command.count("--inertia") == 0;
  }
};

std::vector<report::Experiment> experiments_of(const ReportOptions& options) {
  std::vector<scene::Scene> scenes = options.scenes.scenes();
  // As other commands: the options change one scene.
  if (options.command.count("SCENE") == 0 && !options.solves_tasks()) scenes.resize(1);
  std::vector<report::Experiment> experiments;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    std::vector<std::string> source = options.scenes.words(i);
    source.front() = argument_of(source.front());
    experiments.push_back({scenes[i], commands_of(scenes[i], source, options.command)});
  }
  return experiments;
}

/// The page of the first scene, to stand above its results.
report::Viewer viewer_of(const std::string& empty, const PageScene& scene) {
  const std::string poster = poster_html(scene.shown);
  const std::size_t policy = empty.find("<meta http-equiv=\"Content-Security-Policy\"");
  const std::size_t end = policy == std::string::npos ? policy : empty.find('>', policy) + 1;
  return {page_html(empty, scene, poster),
          policy == std::string::npos ? "" : empty.substr(policy, end - policy), poster};
}

bool is_markdown(const std::string& output) {
  const std::string ending = std::filesystem::path(output).extension().string();
  if (ending == ".md") return true;
  if (ending == ".html" || output == "-") return false;
  throw InvalidArgument("report " + output, "its name must end in .html or .md");
}

report::Document document_of(const ReportOptions& options,
                             const std::vector<report::Experiment>& experiments) {
  return {experiments.size() > 1 ? "The motion of a free rigid body"
                                 : experiments.front().scene.shown_title(),
          text::escape(options.author),
          text::escape(options.date),
          text::escape(report_command_line(options.command, options.scenes, options.output,
                                           options.is_static)),
          std::string("twrench ") + version,
          options.solves_tasks() ? report::report_on_tasks(experiments, task_commands())
                                 : report::report_on_motions(experiments)};
}

void write_report(const ReportOptions& options) {
  options.scenes.require_not_input(options.output);
  const bool markdown = is_markdown(options.output);
  plot::require_gnuplot("figure.svg");
  const bool interactive = !markdown && !options.is_static;
  const std::string empty = interactive ? page_template({}) : std::string();
  const std::vector<report::Experiment> experiments = experiments_of(options);
  const report::Document document = document_of(options, experiments);
  std::optional<report::Viewer> viewer;
  if (interactive) {
    viewer = viewer_of(empty, {experiments.front().scene, options.scenes.original(),
                               argument_of(options.scenes.sources().front()),
                               options.scenes.mesh_options().given()});
  }
  Output output(options.output);
  const report::Write write = [&](std::string_view text) { output.write(text); };
  const std::filesystem::path path(options.output);
  report::Figures figures;
  if (markdown) {
    figures = report::write_markdown(document, path.parent_path(), path.stem().string(), write);
  } else {
    report::write_html(document, viewer ? &*viewer : nullptr, write);
  }
  // All data is on the disk before the first file appears.
  output.finish();
  for (const auto& figure : figures) figure->commit();
}

}  // namespace

void add_report(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "report", "Write a report on a motion: theory, tables, figures, and what they show");
  command->footer(
      std::string(about_defaults) +
      "Without a scene, --omega and --inertia it solves the tasks of the course, on\n"
      "dzhanibekov, stable-y and stable-z. The figures of Markdown are files beside it.\n"
      "Example: twrench report --author \"A. Student\" -o report.html");
  const auto options = std::make_shared<ReportOptions>(*command);
  command
      ->add_option("-o,--output", options->output,
                   "output file, .html or .md, or - for HTML on standard output")
      ->required()
      ->type_name("FILE");
  command->add_option("--author", options->author, "who wrote it, shown below the title")
      ->type_name("TEXT");
  command->add_option("--date", options->date, "date below the title, in any form")
      ->type_name("TEXT")
      ->default_str("none, so that the report is the same on every day");
  command->add_flag("--static", options->is_static,
                    "leave out the page in which the motion can be turned and changed");
  command->callback([options] { write_report(*options); });
}

}  // namespace twrench::app

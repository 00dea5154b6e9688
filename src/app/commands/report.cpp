#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/commands.h"
#include "app/options/arguments.h"
#include "app/options/command_line.h"
#include "app/options/scene_options.h"
#include "app/terminal/error_report.h"
#include "app/terminal/message.h"
#include "app/terminal/version.h"
#include "base/enumeration.h"
#include "page/page_html.h"
#include "plot/gnuplot.h"
#include "report/command_lines.h"
#include "report/file.h"
#include "report/results.h"
#include "scene/recording_table.h"
#include "system/program.h"
#include "text/escape.h"

namespace twrench::app {
namespace {

/// Returns the command line of `twrench report` with the given arguments, and with --static if
/// `is_static`.
std::string report_command_line(const CLI::App& command, const SceneOptions& scenes,
                                const std::string& output, bool is_static) {
  std::vector<std::string> words{"twrench", "report"};
  if (command.count("SCENE") > 0) {
    for (const std::string& source : scenes.sources()) words.push_back(report::argument_of(source));
  }
  const std::vector<std::string> mesh = scenes.mesh_options().given();
  words.insert(words.end(), mesh.begin(), mesh.end());
  const auto others =
      given_options(command, {"--omega", "--attitude", "--wheel", "--energy-loss-time", "--inertia",
                              "--method", "--step", "--tolerance", "--duration", "--fps", "--speed",
                              "--language", "--author", "--date"});
  words.insert(words.end(), others.begin(), others.end());
  if (is_static) words.emplace_back("--static");
  words.insert(words.end(), {"-o", report::argument_of(output)});
  return system::shell_command(words);
}

/// Returns the command lines for an experiment. `source` is its scene as an argument and, if it is
/// a mesh, the options of the mesh; `command` is that of the report, whose options apply to them.
report::Commands commands_of(const scene::Scene& scene, const std::vector<std::string>& source,
                             const CLI::App& command) {
  return report::commands_of(scene, source, given_options(command, {"--inertia"}),
                             given_options(command, {"--omega", "--attitude", "--wheel",
                                                     "--energy-loss-time", "--duration"}));
}

const std::vector<std::string> three_experiments{"dzhanibekov", "stable-y", "stable-z"};

struct ReportOptions {
  explicit ReportOptions(CLI::App& app)
      : command(app),
        scenes(app, SceneOptions::Count::several, three_experiments),
        output(app, system::report_output, OutputOptions::Otherwise::none) {
    scenes.add_language_option();  // before --inertia, which gives the scene a title
    scenes.add_motion_options();
  }

  CLI::App& command;
  SceneOptions scenes;
  OutputOptions output;
  std::string author, date;
  bool is_static = false;

  /// Whether this is the course's report: its experiments, unchanged.
  bool solves_tasks() const {
    const auto is_given = [this](const char* option) { return command.count(option) > 0; };
    return std::ranges::none_of(
        std::array{"SCENE", "--omega", "--attitude", "--wheel", "--energy-loss-time", "--inertia"},
        is_given);
  }
};

std::vector<report::Experiment> experiments_of(const ReportOptions& options) {
  std::vector<scene::Scene> scenes = options.scenes.scenes();
  for (const scene::Scene& scene : scenes) scene::require_computed(scene, "a report");
  // The options change a single scene, as in the other commands.
  if (options.command.count("SCENE") == 0 && !options.solves_tasks()) scenes.resize(1);
  std::vector<report::Experiment> experiments;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    std::vector<std::string> source = options.scenes.words(i);
    source.front() = report::argument_of(source.front());
    experiments.push_back({scenes[i], commands_of(scenes[i], source, options.command)});
  }
  return experiments;
}

/// The page of the first scene, which is placed above its results.
report::Viewer viewer_of(const std::string& empty, const page::PageScene& scene) {
  film::PagePictures pictures;
  const page::PageDocument page = page::page_html(empty, scene, [&] {
    pictures = pictures_or_nothing(scene.shown, scene.has_article);
    return pictures.poster + pictures.stills;
  });
  for (const std::string& note : page.notes) say("twrench: {}\n", note);
  return {page.html, page::content_policy(empty), pictures.poster};
}

report::Document document_of(const ReportOptions& options,
                             const std::vector<report::Experiment>& experiments) {
  return {experiments.front().scene.language,
          report::title_of(experiments),
          text::escape(options.author),
          text::escape(options.date),
          text::escape(report_command_line(options.command, options.scenes, options.output.path(),
                                           options.is_static)),
          std::string("twrench ") + version,
          options.solves_tasks() ? report::report_on_tasks(experiments, report::task_commands())
                                 : report::report_on_motions(experiments)};
}

void write_report(const ReportOptions& options) {
  system::FileList files = options.output.files();
  options.scenes.add_inputs(files);
  const system::OutputFile file = options.output.add_to(files);
  plot::require_gnuplot(system::plot_output.formats.front());
  const bool wants_page = file.format().name == "html" && !options.is_static;
  const std::string missing = wants_page ? page::note_on_missing_page() : std::string();
  if (!missing.empty()) say("twrench: note: {}\n", missing);
  const bool interactive = wants_page && missing.empty();
  const std::string empty = interactive ? page::page_template({}) : std::string();
  const std::vector<report::Experiment> experiments = experiments_of(options);
  const std::string note = report::note_on_language(experiments);
  if (!note.empty()) say("twrench: note: {}\n", note);
  const report::Document document = document_of(options, experiments);
  std::optional<report::Viewer> viewer;
  if (interactive) {
    viewer =
        viewer_of(empty, {experiments.front().scene,
                          options.scenes.original(0),
                          report::argument_of(options.scenes.sources().front()),
                          options.scenes.mesh_options().given(),
                          {},
                          false,
                          options.command.count("--language") > 0 ? std::optional(document.language)
                                                                  : std::nullopt});
  }
  report::write_report(file, document, viewer ? &*viewer : nullptr, files);
}

}  // namespace

void add_report(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "report", "Write a report on a motion: theory, tables, figures and conclusions");
  command->footer(
      std::string(about_defaults) +
      "Without a scene and options of the motion it solves the tasks of the course, on\n"
      "dzhanibekov, stable-y and stable-z. The figures of Markdown are files beside it.\n"
      "Example: twrench report --author \"A. Student\" -o report.html");
  const auto options = std::make_shared<ReportOptions>(*command);
  command->get_option("--language")
      ->description(fmt::format("language of the report, and of a built-in story: {}",
                                fmt::join(enumerator_names<scene::Language>(), " or ")))
      ->group(heading(OptionGroup::output));
  command->add_option("--author", options->author, "who wrote it, shown below the title")
      ->type_name("TEXT")
      ->group(heading(OptionGroup::output));
  command->add_option("--date", options->date, "date below the title, in any form")
      ->type_name("TEXT")
      ->default_str("none, so that the report is the same on every day")
      ->group(heading(OptionGroup::output));
  command
      ->add_flag("--static", options->is_static,
                 "leave out the page in which the motion can be turned and changed")
      ->group(heading(OptionGroup::output));
  command->callback([options] { write_report(*options); });
}

}  // namespace twrench::app

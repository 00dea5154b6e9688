#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/commands.h"
#include "app/output.h"
#include "app/page_html.h"
#include "app/scene_options.h"
#include "app/version.h"
#include "plot/gnuplot.h"
#include "report/html.h"
#include "report/markdown.h"
#include "report/results.h"
#include "system/program.h"

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
  std::string output;
  bool is_static = false;
};

/// The options with those names as they were given.
std::vector<std::string> given(const CLI::App& command, const std::vector<std::string>& names) {
  std::vector<std::string> words;
  for (const std::string& name : names) {
    const CLI::Option& option = *command.get_option(name);
    if (option.count() == 0) continue;
    const std::string& value = option.results().front();
    // "--omega -1,0,0" would be an option's name.
    words.push_back(name + (value.starts_with('-') ? "=" + value : ""));
    if (!value.starts_with('-')) words.push_back(value);
  }
  return words;
}

std::string line_of(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return system::shell_command(words);
}

report::Commands commands_of(const scene::Scene& scene, const std::string& source,
                             const CLI::App& command) {
  const std::string body = line_of({source}, given(command, {"--inertia"}));
  const std::string motion =
      line_of({source}, given(command, {"--inertia", "--omega", "--duration"}));
  const motion::StepControl& control = scene.motion.control;
  return {.inertia = "twrench inertia " + body,
          .constants = "twrench study " + motion + " --methods exact",
          .components =
              "twrench plot " + motion + " --method exact -o components-" + scene.name + ".svg",
          .own_method = fmt::format("twrench study {} --method {} --step {} --tolerance {}", motion,
                                    scene.motion.method, control.step, control.tolerance),
          .methods = "twrench study " + motion,
          .diagrams = "twrench study " + motion + " --plot methods.svg"};
}

std::vector<report::Experiment> experiments_of(const ReportOptions& options) {
  std::vector<report::Experiment> experiments;
  std::size_t i = 0;
  for (const scene::Scene& scene : options.scenes.scenes()) {
    const std::string& source = options.scenes.sources()[i++];
    experiments.push_back({scene, commands_of(scene, source, options.command)});
  }
  return experiments;
}

std::string command_of(const ReportOptions& options) {
  std::vector<std::string> words{"twrench", "report"};
  if (options.command.count("SCENE") > 0) {
    words.insert(words.end(), options.scenes.sources().begin(), options.scenes.sources().end());
  }
  const auto motion = given(options.command, {"--omega", "--inertia", "--method", "--step",
                                              "--tolerance", "--duration", "--fps", "--speed"});
  words.insert(words.end(), motion.begin(), motion.end());
  if (options.is_static) words.emplace_back("--static");
  return line_of(std::move(words), {"-o", options.output});
}

/// The page of the first scene, to stand above its results.
report::Viewer viewer_of(const std::string& empty, const report::Experiment& experiment,
                         const std::string& source) {
  const std::string poster = poster_html(experiment.scene);
  const std::size_t policy = empty.find("<meta http-equiv=\"Content-Security-Policy\"");
  const std::size_t end = policy == std::string::npos ? policy : empty.find('>', policy) + 1;
  return {page_html(empty, experiment.scene, source, poster),
          policy == std::string::npos ? "" : empty.substr(policy, end - policy), poster};
}

bool is_markdown(const std::string& output) {
  const std::string ending = std::filesystem::path(output).extension().string();
  if (ending == ".md") return true;
  if (ending == ".html" || output == "-") return false;
  throw InvalidArgument("report " + output, "its name must end in .html or .md");
}

void write_report(const ReportOptions& options) {
  options.scenes.require_not_input(options.output);
  const bool markdown = is_markdown(options.output);
  plot::require_gnuplot("figure.svg");
  const bool interactive = !markdown && !options.is_static;
  const std::string empty = interactive ? page_template({}) : std::string();
  const std::vector<report::Experiment> experiments = experiments_of(options);
  const scene::Scene& first = experiments.front().scene;
  const report::Document document{experiments.size() > 1 ? "The motion of a free rigid body"
                                  : first.title.empty()  ? first.name
                                                         : first.title,
                                  command_of(options), std::string("twrench ") + version,
                                  report::results(experiments)};
  std::optional<report::Viewer> viewer;
  if (interactive) {
    viewer = viewer_of(empty, experiments.front(), options.scenes.sources().front());
  }
  Output output(options.output);
  const report::Write write = [&](std::string_view text) { output.write(text); };
  const std::filesystem::path path(options.output);
  if (markdown) {
    report::write_markdown(document, path.parent_path(), path.stem().string(), write);
  } else {
    report::write_html(document, viewer ? &*viewer : nullptr, write);
  }
  output.finish();
}

}  // namespace

void add_report(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "report",
      "Write the results of a motion: tables, figures and formulas, ready to be discussed");
  command->footer(std::string(about_defaults) +
                  "Without a scene it is of three: dzhanibekov, stable-y and stable-z.\n"
                  "The figures of Markdown are files beside it.\n"
                  "Example: twrench report -o report.html");
  const auto options = std::make_shared<ReportOptions>(*command);
  command
      ->add_option("-o,--output", options->output,
                   "output file, .html or .md, or - for HTML on standard output")
      ->required()
      ->type_name("FILE");
  command->add_flag("--static", options->is_static,
                    "leave out the page in which the motion can be turned and changed");
  command->callback([options] { write_report(*options); });
}

}  // namespace twrench::app

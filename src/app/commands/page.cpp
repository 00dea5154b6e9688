#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/commands/commands.h"
#include "app/options/arguments.h"
#include "app/options/command_line.h"
#include "app/options/scene_options.h"
#include "app/terminal/error_report.h"
#include "app/terminal/message.h"
#include "base/enumeration.h"
#include "page/page_html.h"
#include "page/site_html.h"
#include "scene/languages.h"
#include "scene/motion_summary.h"
#include "system/file.h"
#include "system/output.h"

namespace twrench::app {
namespace {

struct PageOptions {
  explicit PageOptions(CLI::App& app)
      : command(app),
        scenes(app),
        output(app, system::page_output, OutputOptions::Otherwise::none) {
    scenes.add_motion_options();
    scenes.add_recording_options();
    scenes.add_look_options();
    scenes.add_language_option();
  }

  CLI::App& command;
  SceneOptions scenes;
  OutputOptions output;
  std::string template_file;
  bool all = false;
  bool is_lab = false;
};

/// The files that the command reads.
system::FileList inputs_of(const PageOptions& options) {
  system::FileList files = options.output.files();
  options.scenes.add_inputs(files);
  files.add_input(options.template_file);
  return files;
}

/// The language that --language gives the page. Prints a note if the page has another.
std::optional<scene::Language> language_of(const PageOptions& options, const scene::Scene& scene) {
  const bool is_given = options.command.count("--language") > 0;
  if (!scene::note_on_language(scene).empty()) {
    say("twrench: note: the page is in English, not in '{}'\n", scene.language_tag);
  }
  return is_given ? std::optional(scene.language) : std::nullopt;
}

/// The page of a scene with its poster.
struct ScenePage {
  std::string html, poster;
};

ScenePage page_of(const PageOptions& options, const std::string& empty, const scene::Scene& scene,
                  std::size_t index) {
  const page::PageScene shown{page::shown_scene(scene),
                              options.scenes.original(index),
                              options.scenes.sources().at(index),
                              options.scenes.mesh_options().given(),
                              options.scenes.recording_options().given(),
                              !options.is_lab,
                              language_of(options, scene)};
  film::PagePictures pictures;
  page::PageDocument page = page::page_html(empty, shown, [&] {
    pictures = pictures_or_nothing(shown.shown, shown.has_article);
    return pictures.poster + pictures.stills;
  });
  for (const std::string& note : page.notes) say("twrench: {}\n", note);
  return {std::move(page.html), std::move(pictures.poster)};
}

void write_page(const PageOptions& options) {
  system::FileList files = inputs_of(options);
  const system::OutputFile file = options.output.add_to(files);
  const std::string empty = page::page_template(options.template_file);
  system::write_output(file, page_of(options, empty, options.scenes.scene(), 0).html);
}

/// Writes the pages of all built-in scenes to a folder, and last their index.
void write_site(PageOptions& options) {
  if (options.output.path() == "-") {
    throw InvalidArgument("--all", "writes a folder, which standard output cannot be",
                          "name the folder: -o site");
  }
  if (options.command.count("--motion") > 0) {
    throw InvalidArgument("--all",
                          "takes all built-in scenes, and --motion is a recording of one body",
                          "leave one of them out");
  }
  options.scenes.use_builtin_scenes("--all");
  const std::filesystem::path folder = options.output.path();
  const std::vector<scene::Scene> scenes = options.scenes.scenes();
  system::FileList files = inputs_of(options);
  const system::OutputFile index = files.add_output(system::index_output, folder / "index.html");
  std::vector<system::OutputFile> page_files;
  for (const scene::Scene& scene : scenes) {
    page_files.push_back(files.add_output(system::page_output, folder / (scene.name + ".html")));
  }
  const std::string empty = page::page_template(options.template_file);
  system::make_folder(folder);
  std::vector<page::SiteEntry> entries;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    ScenePage page = page_of(options, empty, scenes[i], i);
    system::write_output(page_files[i], page.html);
    entries.push_back({page_files[i].path().filename().string(), scenes[i].shown_title(),
                       motion_summary(page::shown_scene(scenes[i])), std::move(page.poster)});
  }
  system::write_output(index, page::site_html(entries));
}

}  // namespace

void add_page(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "page", "Write one HTML file in which the motion can be turned, scrubbed and changed");
  command->footer(std::string(about_defaults) +
                  "The page needs no network and no server: it can be mailed.\n"
                  "Example: twrench page dzhanibekov -o flip.html");
  const auto options = std::make_shared<PageOptions>(*command);
  CLI::Option& output = *command->get_option("--output");
  output.description(output.get_description() + "; with --all a folder");
  command->get_option("--language")
      ->description(fmt::format("language of the page, and of a built-in story: {}",
                                fmt::join(enumerator_names<scene::Language>(), " or ")))
      ->default_str("the scene's if it is not English, otherwise the reader's");
  command
      ->add_flag("--all", options->all,
                 "write the pages of all built-in scenes, and index.html with a picture of each")
      ->group(heading(OptionGroup::output));
  command
      ->add_flag("--lab", options->is_lab,
                 "leave out the article, which explains why the body turns over")
      ->group(heading(OptionGroup::output));
  command
      ->add_option("--template", options->template_file,
                   "the page without a scene, as scripts/maintain/page.sh builds it")
      ->type_name("FILE")
      ->default_str("the one built in")
      ->group(heading(OptionGroup::output));
  command->callback([options] { options->all ? write_site(*options) : write_page(*options); });
}

}  // namespace twrench::app

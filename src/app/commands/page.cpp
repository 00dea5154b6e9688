#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/commands.h"
#include "app/options/scene_options.h"
#include "app/reports/page_html.h"
#include "app/terminal/output.h"
#include "system/file.h"

namespace twrench::app {
namespace {

struct PageOptions {
  explicit PageOptions(CLI::App& command) : scene(command) {
    scene.add_motion_options();
    scene.add_look_options();
  }

  SceneOptions scene;
  std::string output;
  std::string template_file;
};

void write_page(const PageOptions& options) {
  options.scene.require_not_input(options.output);
  if (!options.template_file.empty()) {
    system::require_not_input(options.output, options.template_file);
  }
  const std::string empty = page_template(options.template_file);
  const PageScene scene{options.scene.scene(), options.scene.original(),
                        options.scene.sources().front(), options.scene.mesh_options().given()};
  write_output(options.output, page_html(empty, scene, poster_html(scene.shown)));
}

}  // namespace

void add_page(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "page", "Write one HTML file in which the motion can be turned, scrubbed and changed");
  command->footer(std::string(about_defaults) +
                  "The page needs no network and no server: it can be mailed.\n"
                  "Example: twrench page dzhanibekov -o flip.html");
  const auto options = std::make_shared<PageOptions>(*command);
  command->add_option("-o,--output", options->output, "output file, or - for standard output")
      ->required()
      ->type_name("FILE");
  command
      ->add_option("--template", options->template_file,
                   "the page without a scene, as scripts/page.sh builds it")
      ->type_name("FILE")
      ->default_str("the one built in");
  command->callback([options] { write_page(*options); });
}

}  // namespace twrench::app

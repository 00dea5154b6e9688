#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/options/arguments.h"
#include "scene/scene_schema.h"
#include "system/output.h"

namespace twrench::app {

void add_schema(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("schema", "Print the JSON Schema of scene files, for editors");
  command->footer(
      "Even Better TOML and other editors that use taplo read it for a scene file that begins "
      "with\n"
      "#:schema ./twrench.schema.json\n"
      "Example: twrench schema -o twrench.schema.json");
  const auto output = std::make_shared<OutputOptions>(*command, system::schema_output);
  command->callback([output] {
    system::FileList files = output->files();
    system::write_output(output->add_to(files), scene::scene_schema().dump(2) + "\n");
  });
}

}  // namespace twrench::app

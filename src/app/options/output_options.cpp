#include "app/options/output_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <vector>

#include "app/options/arguments.h"
#include "app/options/command_line.h"

namespace twrench::app {

void add_overwrite_option(CLI::App& command, bool& overwrite) {
  command
      .add_flag("--overwrite", overwrite,
                "replace existing files that twrench did not write, or that are of another kind")
      ->group(heading(OptionGroup::output));
}

OutputOptions::OutputOptions(CLI::App& command, const system::OutputKind& kind, Otherwise otherwise)
    : kind_(kind) {
  using Choice = system::OutputKind::Choice;
  const bool streams = kind.choice != Choice::files_only;
  CLI::Option* const output =
      command
          .add_option("-o,--output", path_,
                      fmt::format("output file, {}{}", system::listed_endings(kind),
                                  streams ? "; - for standard output" : ""))
          ->type_name("FILE")
          ->group(heading(OptionGroup::output));
  otherwise == Otherwise::none ? output->required() : output->capture_default_str();
  if (kind.has_format_option()) {
    std::vector<std::string> names;
    for (const system::OutputFormat& format : kind.formats) names.emplace_back(format.name);
    add_format_option(command, format_, names)
        ->default_str("the ending of the file" +
                      (kind.choice == Choice::by_default ? ", else " + names.front() : ""));
  }
  add_overwrite_option(command, overwrite_);
}

}  // namespace twrench::app

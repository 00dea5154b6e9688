#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/commands.h"
#include "app/options/output_options.h"
#include "app/reports/case_report.h"
#include "system/output.h"

namespace twrench::app {
namespace {

struct CasesOptions {
  explicit CasesOptions(CLI::App& command) : output(command, system::list_of_cases) {}

  std::string name;
  OutputOptions output;
};

std::string list_of_cases(std::string_view format) {
  std::vector<cases::Case> problems;
  for (const std::string& name : cases::case_names()) {
    problems.push_back(cases::load_case(name, "case"));
  }
  if (format == "json") return list_json(problems);
  return format == "csv" ? list_csv(problems) : list_text(problems);
}

std::string single_case(const std::string& name, std::string_view format) {
  const cases::Case problem = cases::load_case(name, "case");
  if (format == "json") return case_document(problem);
  return format == "csv" ? case_csv(problem) : case_text(problem);
}

}  // namespace

void add_cases(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "cases", "List published test problems, or print one with its exact values");
  command->footer(
      "Example: twrench cases basilisk-spacecraft\n"
      "The CSV of one case is a table that twrench check --case reads.");
  const auto options = std::make_shared<CasesOptions>(*command);
  command->add_option("NAME", options->name, "name of a case; without it, all are listed");
  command->callback([options, command] {
    const bool lists = command->count("NAME") == 0;
    system::FileList files = options->output.files();
    const system::OutputFile file =
        lists ? options->output.add_to(files) : options->output.add_to(files, system::case_output);
    const std::string_view format = file.format().name;
    system::write_output(file, lists ? list_of_cases(format) : single_case(options->name, format));
  });
}

}  // namespace twrench::app

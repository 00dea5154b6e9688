#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/commands.h"
#include "app/options/arguments.h"
#include "app/reports/case_report.h"
#include "system/output.h"

namespace twrench::app {
namespace {

struct CasesOptions {
  std::string name;
  std::string format = "text";
  std::string output = "-";
};

std::string list_of_cases(const std::string& format) {
  std::vector<cases::Case> problems;
  for (const std::string& name : cases::case_names()) {
    problems.push_back(cases::load_case(name, "case"));
  }
  if (format == "json") return list_json(problems);
  return format == "csv" ? list_csv(problems) : list_text(problems);
}

std::string single_case(const std::string& name, const std::string& format) {
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
  const auto options = std::make_shared<CasesOptions>();
  command->add_option("NAME", options->name, "name of a case; without it, all are listed");
  add_format_option(*command, options->format, {"text", "json", "csv"});
  add_output_option(*command, options->output);
  command->callback([options] {
    system::write_output(options->output, options->name.empty()
                                              ? list_of_cases(options->format)
                                              : single_case(options->name, options->format));
  });
}

}  // namespace twrench::app

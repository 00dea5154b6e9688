#include "report/tables.h"

#include <algorithm>

namespace twrench::report {

std::string digits(double value) {
  if (!std::isfinite(value)) return "–";
  return fmt::format("{:.8g}", value + 0.0);  // no minus before 0
}

std::string brief(double value) {
  if (!std::isfinite(value)) return "–";
  return value == 0 ? "0" : fmt::format("{:.2e}", value);
}

const study::MethodStudy& results_of(const study::Study& study, std::string_view method) {
  return *std::ranges::find(study.methods, method,
                            [](const study::MethodStudy& m) { return m.method->name; });
}

std::string measured_order(const study::Study& study, std::string_view method) {
  const std::optional<double> order = results_of(study, method).order;
  return order ? fmt::format("{:.2f}", *order) : "–";
}

Table ladder_table(const study::Study& study, const std::vector<std::string>& methods,
                   const Experiment& studied) {
  const Language language = studied.scene.language;
  Table table{.caption = Phrase("{}: error of X at {:.4g} s by step",
                                "{}: feil i X ved {:.4g} s etter steglengde")
                             .in(language, studied.scene.name, study.early),
              .commands = {studied.commands.study_of(methods)},
              .header = {step_label.in(language)},
              .rows = {}};
  std::vector<std::string> orders{Phrase("Measured order", "Målt orden").in(language)};
  for (const std::string& method : methods) {
    table.header.push_back(method);
    orders.push_back(measured_order(study, method));
  }
  const std::size_t steps = results_of(study, methods.front()).runs.size();
  for (std::size_t i = 0; i < steps; ++i) {
    std::vector<std::string> row{
        fmt::format("{:.6g}", results_of(study, methods.front()).runs[i].step)};
    for (const std::string& method : methods) {
      const study::StudyRun& run = results_of(study, method).runs[i];
      row.push_back(run.failure.empty() ? brief(run.early_error) : "–");
    }
    table.rows.push_back(std::move(row));
  }
  table.rows.push_back(std::move(orders));
  return table;
}

const study::StudyRun* middle_run(const study::MethodStudy& method) {
  for (std::size_t i = method.runs.size() / 2; i < method.runs.size(); ++i) {
    if (method.runs[i].failure.empty()) return &method.runs[i];
  }
  return nullptr;
}

}  // namespace twrench::report

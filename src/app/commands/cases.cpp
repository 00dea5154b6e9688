#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/commands/commands.h"
#include "app/options/arguments.h"
#include "base/enumeration.h"
#include "cases/case.h"
#include "system/output.h"

namespace twrench::app {
namespace {

// The list of cases, one line each, and a single case in full. Numbers in CSV and JSON, and exact
// values everywhere, have 17 significant digits.

using cases::Case;
using cases::Published;
using cases::State;

/// The unit with a space before it; not every source states one.
std::string unit_after(const std::string& unit) { return unit.empty() ? "" : " " + unit; }

/// "500, 200, 300 kg m^2"
std::string inertia_text(const Case& problem) {
  return fmt::format("{:.7g}{}", fmt::join(problem.moments, ", "),
                     unit_after(problem.inertia_unit));
}

/// "10, 20, 30 deg/s"
std::string omega_text(const Case& problem) {
  return fmt::format("{:.7g} {}", fmt::join(problem.published_omega, ", "), problem.omega_unit);
}

/// A cell of CSV, in quotes.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

std::string dumped(const nlohmann::ordered_json& document) { return document.dump(1) + "\n"; }

Eigen::Vector4d scalar_first(const Eigen::Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }

std::string exact_row(const auto& v) { return fmt::format("{:>25}\n", fmt::join(v, "")); }

std::string parameters_text(const Case& problem) {
  std::string text = fmt::format(
      "case      {}: {}\n"
      "source    {}\n"
      "          {}\n"
      "inertia   {}{}\n"
      "omega     {} {}\n",
      problem.name, problem.title, problem.source, problem.url, fmt::join(problem.moments, ", "),
      unit_after(problem.inertia_unit), fmt::join(problem.published_omega, ", "),
      problem.omega_unit);
  if (problem.omega_unit != "rad/s") {
    text += fmt::format("          {} rad/s\n", fmt::join(problem.omega, ", "));
  }
  if (problem.attitude) {
    text += fmt::format("attitude  {} (space from body, scalar first)\n",
                        fmt::join(scalar_first(*problem.attitude), ", "));
  }
  text += fmt::format("duration  {} s\nnote      ", problem.duration);
  for (const char c : problem.note) text += c == '\n' ? "\n          " : std::string(1, c);
  return text + "\n";
}

const char* component_name(const Published& published, std::size_t i) {
  static constexpr std::array quaternion{"w", "x", "y", "z"};
  return quaternion.at(published.quantity == cases::Quantity::quaternion ? i : i + 1);
}

std::string published_text(const Published& published, const State& exact) {
  const std::vector<double> components = cases::exact_components(published, exact);
  const std::string by = published.by.empty() ? "" : " by " + published.by;
  const std::string unit = published.unit.empty() ? "" : ", " + published.unit;
  std::string text =
      fmt::format("\n{}{}, at t = {} s, published{}: ", enumerator_name(published.quantity), unit,
                  published.time, by);
  text += is_right_to_its_digits(published, exact)
              ? "right to its last digit\n"
              : fmt::format("off by up to {:.3g}\n", largest_difference(published, exact));
  text += fmt::format("{:>3}{:>25}{:>25}{:>12}\n", "", "published", "exact", "difference");
  for (std::size_t i = 0; i < components.size(); ++i) {
    text += fmt::format("{:>3}{:>25}{:>25}{:>12.2g}\n", component_name(published, i),
                        published.digits[i], components[i], published.values[i] - components[i]);
  }
  return text;
}

std::string state_text(const Case& problem, const State& state) {
  return fmt::format(
      "\nexact values at t = {} s\n"
      "  omega, body axes, rad/s\n  {}"
      "  quaternion, space from body, scalar first\n  {}"
      "  energy, {}\n  {:>25}\n"
      "  L, space axes, {}\n  {}",
      state.t, exact_row(state.omega), exact_row(scalar_first(state.quaternion)),
      energy_unit(problem), state.energy, momentum_unit(problem), exact_row(state.momentum));
}

std::string list_text(const std::vector<Case>& problems) {
  std::vector<std::array<std::string, 5>> rows{{"name", "inertia", "omega", "duration", "source"}};
  for (const Case& problem : problems) {
    rows.push_back({problem.name, inertia_text(problem), omega_text(problem),
                    fmt::format("{:.4g} s", problem.duration), problem.source});
  }
  std::array<std::size_t, 5> widths{};
  for (const auto& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      widths.at(i) = std::max(widths.at(i), row.at(i).size() + 2);
    }
  }
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      text += fmt::format("{:<{}}", row.at(i), widths.at(i));
    }
    text += '\n';
  }
  return text;
}

std::string list_csv(const std::vector<Case>& problems) {
  std::string text = "name,I1,I2,I3,inertia_unit,wx,wy,wz,duration,title,source\n";
  for (const Case& problem : problems) {
    text += fmt::format("{},{},{},{},{},{},{}\n", problem.name, fmt::join(problem.moments, ","),
                        quoted(problem.inertia_unit), fmt::join(problem.omega, ","),
                        problem.duration, quoted(problem.title), quoted(problem.source));
  }
  return text;
}

std::string list_json(const std::vector<Case>& problems) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Case& problem : problems) list.push_back(cases::summary_json(problem));
  return dumped({{"cases", list}});
}

std::string case_text(const Case& problem) {
  const cases::Solution solution(problem);
  std::string text = parameters_text(problem);
  for (const Published& published : problem.published) {
    text += published_text(published, solution.at(published.time));
  }
  for (const double t : cases::times_of(problem)) text += state_text(problem, solution.at(t));
  return text;
}

/// The exact states as a table that `check` reads.
std::string case_csv(const Case& problem) {
  const cases::Solution solution(problem);
  std::string text = "t,wx,wy,wz,qw,qx,qy,qz,energy,Lx,Ly,Lz\n";
  for (const double t : cases::times_of(problem)) {
    const State state = solution.at(t);
    text += fmt::format("{},{},{},{},{}\n", t, fmt::join(state.omega, ","),
                        fmt::join(scalar_first(state.quaternion), ","), state.energy,
                        fmt::join(state.momentum, ","));
  }
  return text;
}

std::string case_document(const Case& problem) { return dumped(cases::case_json(problem)); }

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

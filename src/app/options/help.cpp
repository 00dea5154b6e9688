#include "app/options/help.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/options/command_model.h"
#include "base/enumeration.h"
#include "base/nearest.h"
#include "system/output.h"

namespace twrench::app {
namespace {

/// "-o,--output FILE"
std::string left_of(const Option& option) {
  const std::string names = fmt::format("{}", fmt::join(option.names, ","));
  return option.placeholder.empty() ? names : names + " " + option.placeholder;
}

std::string right_of(const Option& option) {
  if (option.otherwise.empty()) return option.help;
  return fmt::format("{} (default: {})", option.help, option.otherwise);
}

std::string help_line(const std::string& left, const std::string& right) {
  constexpr std::size_t column = 26;
  const bool fits = left.size() < column;
  return fmt::format("  {:<{}}{}{}\n", left, column,
                     fits ? "" : "\n" + std::string(column + 2, ' '), right);
}

std::string section(const std::string& title, const std::vector<Option>& options) {
  std::string text = options.empty() ? "" : "\n" + title + ":\n";
  for (const Option& option : options) text += help_line(left_of(option), right_of(option));
  return text;
}

constexpr std::size_t most_options = 24;

bool is_long(const Command& command) { return command.options.size() > most_options; }

/// The most used options of each command with many options, the most used one first.
const std::vector<std::string>& most_used_of(const Command& command) {
  static const std::map<std::string, std::vector<std::string>> all{
      {"render",
       {"--output", "--size", "--duration", "--speed", "--length", "--omega", "--view", "--show",
        "--title", "--motion"}},
      {"export",
       {"--output", "--format", "--max-angle", "--fps", "--duration", "--speed", "--omega",
        "--inertia", "--method", "--motion"}},
      {"simulate",
       {"--output", "--format", "--times", "--fps", "--duration", "--omega", "--inertia",
        "--method", "--step", "--motion"}},
      {"page",
       {"--output", "--omega", "--inertia", "--duration", "--speed", "--motion", "--theme",
        "--material", "--color", "--unit"}},
      {"plot",
       {"--output", "--overlay", "--omega", "--inertia", "--duration", "--method", "--step",
        "--motion", "--unit", "--density"}},
      {"study",
       {"--methods", "--steps", "--tolerances", "--duration", "--omega", "--inertia", "--output",
        "--format", "--plot", "--max-error"}},
      {"check",
       {"--inertia", "--scene", "--case", "--omega", "--units", "--columns", "--output", "--format",
        "--plot", "--max-rate-error"}}};
  return all.at(command.name);
}

std::vector<Option> most_used_options(const Command& command) {
  std::vector<Option> options;
  for (const std::string& name : most_used_of(command)) {
    const auto has_name = [&](const Option& option) { return option.names.back() == name; };
    options.push_back(*std::ranges::find_if(command.options, has_name));
  }
  return options;
}

std::vector<Option> options_in(const Command& command, OptionGroup group) {
  std::vector<Option> options;
  std::ranges::copy_if(command.options, std::back_inserter(options),
                       [group](const Option& option) { return option.group == group; });
  return options;
}

/// "  Camera      --azimuth --elevation", in lines that fit a terminal.
std::string names_line(const std::string& title, const std::vector<std::string>& names) {
  constexpr std::size_t column = 14, longest = 100;
  std::string text, line = fmt::format("  {:<{}}", title, column - 2);
  for (const std::string& name : names) {
    if (line.size() + name.size() + 1 > longest) {
      text += line + "\n";
      line.assign(column, ' ');
    }
    line += (line.ends_with(' ') ? "" : " ") + name;
  }
  return text + line + "\n";
}

/// The names of the options without a description, by group.
std::string other_options(const Command& command) {
  const std::vector<std::string>& described = most_used_of(command);
  std::string text = "\nMore options, which --help-all describes:\n";
  for (const OptionGroup group : enumerators<OptionGroup>) {
    std::vector<std::string> names;
    for (const Option& option : options_in(command, group)) {
      const std::string& name = option.names.back();
      if (std::ranges::find(described, name) == described.end()) names.push_back(name);
    }
    if (!names.empty()) text += names_line(heading(group), names);
  }
  return text;
}

enum class Detail { most_used, all };

std::string option_sections(const Command& command, Detail detail) {
  if (!is_long(command)) return section("Options", command.options);
  if (detail == Detail::most_used) {
    return section("Most used options", most_used_options(command)) + other_options(command);
  }
  std::string text;
  for (const OptionGroup group : enumerators<OptionGroup>) {
    text += section(heading(group), options_in(command, group));
  }
  return text;
}

std::string command_list(const std::vector<Command>& commands) {
  std::string text = commands.empty() ? "" : "\nCommands:\n";
  for (const Command& command : commands) text += help_line(command.name, command.description);
  return text;
}

/// The text of --help or --help-all.
std::string help_text(const CLI::App& app, const std::string& name, Detail detail) {
  const Command command = read_command(app);
  const std::vector<Command> commands = read_commands(app);
  std::string usage = fmt::format("Usage: {} [OPTIONS]", name);
  for (const std::string& argument : command.usage) usage += " " + argument;
  if (!commands.empty()) usage += " COMMAND";
  return fmt::format("{}\n{}\n{}{}{}\n{}\n", command.description, usage,
                     section("Arguments", command.arguments), option_sections(command, detail),
                     command_list(commands), command.footer);
}

class HelpFormat : public CLI::FormatterBase {
 public:
  std::string make_help(const CLI::App* command, std::string name,
                        CLI::AppFormatMode mode) const override {
    const Detail detail = mode == CLI::AppFormatMode::All ? Detail::all : Detail::most_used;
    return help_text(*command, name, detail);
  }
};

}  // namespace

void set_help_format(CLI::App& app) { app.formatter(std::make_shared<HelpFormat>()); }

void add_help_all(CLI::App& app) {
  app.get_option("--help")->group(heading(OptionGroup::run));
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    command->get_option("--help")->group(heading(OptionGroup::run));
    CLI::Option* const flag =
        is_long(read_command(*command))
            ? command->set_help_all_flag("--help-all", "Print this help with all options, and exit")
            : command->set_help_flag("-h,--help,--help-all", "Print this help and exit");
    flag->group(heading(OptionGroup::run));
  }
}

void add_help(CLI::App& app) {
  CLI::App* command = app.add_subcommand("help", "Print this help or that of a command");
  command->footer("Example: twrench help render");
  const auto word = std::make_shared<std::string>();
  command->add_option("COMMAND", *word, "name of a command");
  command->callback([&app, word] {
    const CLI::App* asked = &app;
    std::vector<std::string> names;
    for (const CLI::App* known : app.get_subcommands([](const CLI::App*) { return true; })) {
      names.push_back(known->get_name());
      if (names.back() == *word) asked = known;
    }
    if (asked == &app && !word->empty()) throw unknown_name("command", *word, names);
    const std::string name = app.get_name() + (word->empty() ? "" : " " + *word);
    system::write_output(help_text(*asked, name, Detail::most_used));
  });
}

}  // namespace twrench::app

#include "app/options/help.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <vector>

#include "app/options/command_model.h"
#include "app/terminal/output.h"
#include "base/nearest.h"

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

std::string group(const std::string& title, const std::vector<Option>& options) {
  std::string text = options.empty() ? "" : "\n" + title + ":\n";
  for (const Option& option : options) text += help_line(left_of(option), right_of(option));
  return text;
}

std::string command_list(const std::vector<Command>& commands) {
  std::string text = commands.empty() ? "" : "\nCommands:\n";
  for (const Command& command : commands) text += help_line(command.name, command.description);
  return text;
}

/// The text of --help.
std::string help_text(const CLI::App& app, const std::string& name) {
  const Command command = read_command(app);
  const std::vector<Command> commands = read_commands(app);
  std::string usage = fmt::format("Usage: {} [OPTIONS]", name);
  for (const std::string& argument : command.usage) usage += " " + argument;
  if (!commands.empty()) usage += " COMMAND";
  return fmt::format("{}\n{}\n{}{}{}\n{}\n", command.description, usage,
                     group("Arguments", command.arguments), group("Options", command.options),
                     command_list(commands), command.footer);
}

class HelpFormat : public CLI::FormatterBase {
 public:
  std::string make_help(const CLI::App* command, std::string name,
                        CLI::AppFormatMode /*mode*/) const override {
    return help_text(*command, name);
  }
};

}  // namespace

void set_help_format(CLI::App& app) { app.formatter(std::make_shared<HelpFormat>()); }

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
    write_output("-", help_text(*asked, name));
  });
}

}  // namespace twrench::app

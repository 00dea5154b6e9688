#include "app/help.h"

#include <fmt/format.h>
#include <twrench/base/nearest.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <vector>

#include "app/output.h"

namespace twrench::app {
namespace {

using Options = std::vector<const CLI::Option*>;

bool takes_several(const CLI::Option& option) { return option.get_expected_max() > 1; }

/// "[SCENE...]"
std::string usage_of(const CLI::Option& positional) {
  const std::string name = positional.get_name(true) + (takes_several(positional) ? "..." : "");
  return positional.get_required() ? name : "[" + name + "]";
}

/// "-o,--output FILE"; a flag's {default value} is CLI11's own notation.
std::string left_of(const CLI::Option& option) {
  if (option.get_positional()) return option.get_name(true);
  std::string names = option.get_name(false, true);
  names.resize(std::min(names.find('{'), names.size()));
  const bool is_flag = option.get_expected_max() == 0;
  return is_flag ? names : names + " " + option.get_type_name();
}

std::string right_of(const CLI::Option& option) {
  const std::string otherwise = option.get_default_str();
  if (otherwise.empty()) return option.get_description();
  return fmt::format("{} (default: {})", option.get_description(), otherwise);
}

std::string line(const std::string& left, const std::string& right) {
  constexpr std::size_t column = 26;
  const bool fits = left.size() < column;
  return fmt::format("  {:<{}}{}{}\n", left, column,
                     fits ? "" : "\n" + std::string(column + 2, ' '), right);
}

std::string group(const std::string& title, const Options& options) {
  std::string text = options.empty() ? "" : "\n" + title + ":\n";
  for (const CLI::Option* option : options) text += line(left_of(*option), right_of(*option));
  return text;
}

std::string list(const std::vector<const CLI::App*>& commands) {
  std::string text = commands.empty() ? "" : "\nCommands:\n";
  for (const CLI::App* command : commands) {
    text += line(command->get_name(), command->get_description());
  }
  return text;
}

/// The text of --help.
std::string help_of(const CLI::App* command, const std::string& name) {
  const Options positionals =
      command->get_options([](const CLI::Option* option) { return option->get_positional(); });
  const Options options =
      command->get_options([](const CLI::Option* option) { return option->nonpositional(); });
  const std::vector<const CLI::App*> commands =
      command->get_subcommands([](const CLI::App*) { return true; });
  std::string usage = fmt::format("Usage: {} [OPTIONS]", name);
  for (const CLI::Option* positional : positionals) usage += " " + usage_of(*positional);
  if (!commands.empty()) usage += " COMMAND";
  return fmt::format("{}\n{}\n{}{}{}\n{}\n", command->get_description(), usage,
                     group("Arguments", positionals), group("Options", options), list(commands),
                     command->get_footer());
}

class HelpFormat : public CLI::FormatterBase {
 public:
  std::string make_help(const CLI::App* command, std::string name,
                        CLI::AppFormatMode /*mode*/) const override {
    return help_of(command, name);
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
    write_output("-", help_of(asked, name));
  });
}

}  // namespace twrench::app

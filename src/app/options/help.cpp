#include "app/options/help.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <memory>
#include <string_view>

#include "app/options/command_model.h"
#include "base/enumeration.h"
#include "base/words.h"
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
      {"report",
       {"--output", "--omega", "--inertia", "--duration", "--speed", "--method", "--language",
        "--author", "--unit", "--static"}},
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

namespace {

std::vector<const CLI::App*> all_commands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<const CLI::Option*> all_options(const CLI::App& command) {
  return command.get_options([](const CLI::Option*) { return true; });
}

/// The subject of an error: the command or, if none was given, the command line.
std::string subject(const CLI::App& app, const CLI::App& command) {
  return &command == &app ? "command line" : command.get_name();
}

std::string see_help(const CLI::App& app, const CLI::App& command) {
  return fmt::format("see twrench {}--help", &command == &app ? "" : command.get_name() + " ");
}

InvalidArgument unknown_word(const CLI::App& app, const CLI::App& command,
                             const std::string& word) {
  const std::string help = see_help(app, command);
  if (!word.starts_with("-")) {
    return {subject(app, command), fmt::format("unexpected argument '{}'", word), help};
  }
  std::vector<std::string> names;
  for (const CLI::Option* option : all_options(command)) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  const std::string name = word.substr(0, word.find('='));
  const auto meant = nearest(name, names);
  return {subject(app, command), fmt::format("unknown option '{}'", name),
          meant ? fmt::format("did you mean '{}'? {}", *meant, help) : help};
}

InvalidArgument missing_command(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : all_commands(app)) names.push_back(command->get_name());
  return {subject(app, app), "no command was given",
          fmt::format("one of: {}; see twrench --help", fmt::join(names, ", "))};
}

/// Finds the option that the message mentions: the longest matching name, because one name may be a
/// prefix of another.
const CLI::Option* option_in(const CLI::App& command, std::string_view text) {
  const CLI::Option* found = nullptr;
  for (const CLI::Option* option : all_options(command)) {
    const std::string name = option->get_name();
    const bool is_named = text.find(name) != std::string_view::npos;
    if (is_named && (found == nullptr || name.size() > found->get_name().size())) found = option;
  }
  return found;
}

std::string fault_of(const CLI::Option& option) {
  if (option.get_expected_max() == 0) return "it takes no value";
  if (option.count() > 1) {
    return fmt::format("it can be given only once, but was given {} times, the second as '{}'",
                       option.count(), option.results().at(1));
  }
  return fmt::format("its value {} is missing", placeholder_of(option));
}

}  // namespace

std::vector<std::string> words_for_parser(int argc, const char* const* argv) {
  std::vector<std::string> words;
  for (int i = 1; i < argc; ++i) {
    std::string word = argv[i];
    if (word == "inertia" && !words.empty() && words.back() == "--fit") {
      words.back() += "=inertia";
      continue;
    }
    const bool is_option = std::ranges::find(words, "--") == words.end() && word.starts_with("--");
    const bool is_empty = is_option && word.find('=') + 1 == word.size();
    if (is_empty) word.pop_back();
    words.push_back(std::move(word));
    if (is_empty) words.emplace_back();
  }
  std::ranges::reverse(words);
  return words;
}

void refuse_meaningless_values(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    for (CLI::Option* option : command->get_options([](const CLI::Option*) { return true; })) {
      const std::string name = option->get_name();
      if (name == "--title" || name == "--fit") continue;
      const bool takes_value = option->get_expected_max() > 0 || !option->get_fnames().empty();
      const char* remedy = !option->get_positional() ? "give a value, or omit the option"
                           : option->get_required()  ? "give a value"
                                                     : "give a value, or omit the argument";
      option->check([name, takes_value, remedy](const std::string& value) -> std::string {
        if (value.empty()) throw InvalidArgument(name, "its value is empty", remedy);
        if (!takes_value && value != "true" && value != "false")
          throw InvalidArgument(name, fmt::format("it takes no value, but has '{}'", value),
                                fmt::format("write {} alone", name));
        return {};
      });
    }
  }
}

InvalidArgument usage_error(const CLI::App& app, const CLI::ParseError& error) {
  std::vector<std::string> unknown = app.remaining(true);
  std::erase(unknown, "--");
  const auto given = app.get_subcommands();
  const CLI::App& command = given.empty() ? app : *given.front();
  if (!unknown.empty()) return unknown_word(app, command, unknown.front());
  if (given.empty()) return missing_command(app);
  const std::string help = see_help(app, command);
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
    for (const CLI::Option* option : all_options(command)) {
      if (!option->get_required() || option->count() > 0) continue;
      return {command.get_name(), fmt::format("{} is missing", option->get_name()), help};
    }
  }
  if (const CLI::Option* option = option_in(command, error.what())) {
    return {option->get_name(), fault_of(*option), help};
  }
  return {command.get_name(), error.what(), help};
}

}  // namespace twrench::app

#include "app/options/usage.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "app/options/command_model.h"
#include "base/nearest.h"

namespace twrench::app {
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
      if (name == "--title") continue;
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

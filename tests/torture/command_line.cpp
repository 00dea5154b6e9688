#include "command_line.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

#include "app/commands/commands.h"
#include "option_values.h"

namespace twrench::torture {
namespace {

/// Limits that are added if the command has the option and the case does not set it.
const std::vector<std::pair<std::string, std::string>> small{
    {"size", "64x48"},    {"duration", "1"}, {"fps", "4"},
    {"progress", "none"}, {"speed", "0.5"},  {"methods", "rk4"}};

Option option_of(const CLI::Option& option) {
  const auto& names = option.get_lnames();
  return {option.get_positional() ? option.get_name(true)
          : names.empty()         ? ""
                                  : names.front(),
          option.get_positional(), option.get_items_expected_max() == 0, option.get_required()};
}

const Value& draw_value(const Values& values, Dice& dice) {
  // Root has permission for everything, so cases avoid system files.
  const bool spare_system = ::geteuid() == 0;
  if (dice.chance(0.15)) {
    const Value& hostile = dice.one_of(values.hostile);
    if (!spare_system || !hostile.text.starts_with("/")) return hostile;
  }
  return dice.one_of(values.sensible);
}

void add_option(CommandLine& line, const Option& option, Dice& dice) {
  if (option.is_flag) {
    const bool has_value = option.name == "timing" && dice.chance(0.5);
    const std::string text = has_value ? dice.one_of<std::string>({"json", "text", "xml", ""}) : "";
    line.words.push_back("--" + option.name + (has_value ? "=" + text : ""));
    line.options[option.name] = text;
    return;
  }
  const Value& value = draw_value(values_for(line.command, option.name), dice);
  line.may_last |= value.may_last;
  line.options[option.name] = value.text;
  // A value that begins with a dash must be attached.
  if (value.text.starts_with("-") || dice.chance(0.3)) {
    line.words.push_back("--" + option.name + "=" + value.text);
  } else {
    line.words.insert(line.words.end(), {"--" + option.name, value.text});
  }
}

void add_argument(CommandLine& line, const Option& argument, Dice& dice) {
  const Value& value = draw_value(values_for(line.command, argument.name), dice);
  line.may_last |= value.may_last;
  line.arguments.push_back(value.text);
  line.words.push_back(value.text);
}

/// Distorts a command line: words too many, too few, repeated, unknown, truncated.
void distort(CommandLine& line, Dice& dice) {
  line.is_odd = true;
  auto& words = line.words;
  const auto at = [&] {
    return words.begin() + static_cast<std::ptrdiff_t>(dice.below(words.size()));
  };
  switch (dice.below(7)) {
    case 0:
      words.erase(at());
      break;
    case 1:
      words.push_back(*at());
      break;
    case 2:
      words.insert(at(), dice.one_of<std::string>({"--nosuch", "--nosuch=1", "-x", "-ox", "--", "-",
                                                   "", "--help", "--version", "help", "---",
                                                   "--=", "--\x1b[31m", "\xff", "a\nb"}));
      break;
    case 3: {
      const auto word = at();
      word->resize(word->size() / 2);
      break;
    }
    case 4:
      std::ranges::reverse(words);
      break;
    case 5:
      words.front() = dice.one_of<std::string>({"rendr", "Render", "help", "", "-h", "\x1b[31m",
                                                "\xff", "a\nb", "--versoin", "--help=all"});
      break;
    default:
      words.resize(dice.below(words.size()));
  }
}

void draw_options(CommandLine& line, const std::vector<Option>& options, Dice& dice) {
  std::vector<Option> optional;
  for (const Option& option : options) {
    // All required ones, and usually an optional input.
    if (option.is_argument ? option.is_required || dice.chance(0.8)
                           : option.is_required && dice.chance(0.98)) {
      option.is_argument ? add_argument(line, option, dice) : add_option(line, option, dice);
    } else if (!option.is_argument && !option.is_required && !option.name.starts_with("help")) {
      optional.push_back(option);
    }
  }
  dice.shuffle(optional);
  optional.resize(std::min(optional.size(), dice.below(6)));
  for (const Option& option : optional) add_option(line, option, dice);
}

/// Takes a scene file from a pipe instead.
void pipe_scene(CommandLine& line) {
  if (line.arguments.size() != 1 || !line.arguments.front().ends_with(".toml")) return;
  const auto word = std::ranges::find(line.words, line.arguments.front());
  if (word == line.words.end() || word == line.words.begin() || (word - 1)->starts_with("--"))
    return;
  line.piped_scene = line.arguments.front();
  line.arguments.front() = *word = "/dev/stdin";
}

/// The options for outputs that the line lacks.
std::vector<std::string> further_outputs(const CommandLine& line,
                                         const std::vector<Option>& options) {
  std::vector<std::string> outputs;
  for (const char* name : {"output", "plot", "diff", "report", "fix"}) {
    const auto is_it = [&](const Option& option) { return option.name == name; };
    if (!line.has(name) && std::ranges::any_of(options, is_it)) outputs.emplace_back(name);
  }
  return outputs;
}

/// Passes the name of an existing file, with a fitting ending, to an option for an output.
void aim_at_old_file(CommandLine& line, const std::vector<Option>& options, Dice& dice) {
  const std::vector<std::string> outputs = further_outputs(line, options);
  if (outputs.empty()) return;
  const std::string& name = dice.one_of(outputs);
  std::vector<std::string> old;
  for (const auto& [text, may_last] : values_for(line.command, name).hostile) {
    if (text.starts_with("own_") || text.starts_with("notes") || text.starts_with("to_notes"))
      old.push_back(text);
  }
  line.options[name] = dice.one_of(old);
  line.words.insert(line.words.end(), {"--" + name, line.options[name]});
}

/// Passes the same file to two options for outputs.
void repeat_output(CommandLine& line, const std::vector<Option>& options) {
  const std::vector<std::string> outputs = further_outputs(line, options);
  if (outputs.size() < 2) return;
  for (const auto& [name, value] : {std::pair(outputs[0], "one.svg"), {outputs[1], "./one.svg"}}) {
    line.words.insert(line.words.end(), {"--" + name, value});
    line.options[name] = value;
  }
  line.has_one_output_twice = true;
}

}  // namespace

std::string CommandLine::value(const std::string& option, const std::string& otherwise) const {
  const auto found = options.find(option);
  return found == options.end() ? otherwise : found->second;
}

OptionTable read_option_table() {
  CLI::App app;
  app::ExitCode code{};
  app::add_commands(app, code);
  OptionTable table;
  for (const CLI::App* command : app.get_subcommands({})) {
    auto& options = table[command->get_name()];
    for (const CLI::Option* option : command->get_options()) options.push_back(option_of(*option));
  }
  return table;
}

CommandLine random_command_line(const OptionTable& table, Dice& dice) {
  // Commands that can fail in more ways are drawn more often.
  std::vector<std::string> commands{"render", "render", "render", "render", "simulate", "encode"};
  for (const auto& [command, options] : table) commands.push_back(command);
  CommandLine line;
  line.command = dice.one_of(commands);
  line.words.push_back(line.command);
  const std::vector<Option>& options = table.at(line.command);
  draw_options(line, options, dice);
  for (const auto& bound : small) {
    const auto& [name, value] = bound;
    const auto is_it = [&](const Option& option) { return option.name == bound.first; };
    if (line.has(name) || std::ranges::none_of(options, is_it)) continue;
    line.words.insert(line.words.end(), {"--" + name, value});
    line.options[name] = value;
  }
  // Video takes longest: every other one is omitted.
  if (line.command == "render" && !line.has("no-video") && !line.has("output") &&
      dice.chance(0.5)) {
    line.words.emplace_back("--no-video");
    line.options["no-video"] = "";
  }
  line.has_loud_children = dice.chance(0.2);
  if (dice.chance(0.1)) pipe_scene(line);
  if (dice.chance(0.1)) repeat_output(line, options);
  if (dice.chance(0.2)) aim_at_old_file(line, options, dice);
  if (dice.chance(0.1)) distort(line, dice);
  return line;
}

}  // namespace twrench::torture

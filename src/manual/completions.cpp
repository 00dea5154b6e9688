#include <fmt/format.h>
#include <fmt/ranges.h>

#include "manual/manual.h"

namespace twrench::manual {
namespace {

using app::Candidates;
using app::Command;
using app::Option;
using Kind = Candidates::Kind;

std::vector<std::string> names_of(const std::vector<Command>& commands) {
  std::vector<std::string> names;
  names.reserve(commands.size());
  for (const Command& command : commands) names.push_back(command.name);
  return names;
}

std::vector<std::string> option_names(const Command& command) {
  std::vector<std::string> names;
  for (const Option& option : command.options) {
    names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

/// Quotes text for all three shells.
std::string quoted(const std::string& text) {
  return fmt::format("'{}'", replaced(text, "'", "'\\''"));
}

/// The call of the function, defined in the script, that completes a value.
std::string bash_call(const Candidates& candidates) {
  switch (candidates.kind) {
    case Kind::none:
      return ":";
    case Kind::words:
      return "_twrench_words " + quoted(joined(candidates.words));
    case Kind::list:
      return "_twrench_list " + quoted(joined(candidates.words));
    case Kind::file:
      return "_twrench_files -f";
    case Kind::folder:
      return "_twrench_files -d";
    case Kind::scene:
      return "_twrench_scenes " + quoted(joined(candidates.words)) + " " +
             quoted(joined(candidates.endings));
  }
  return {};
}

std::string bash_cases(const Command& command) {
  std::string text;
  for (const Option& option : command.options) {
    if (option.placeholder.empty()) continue;
    for (const std::string& name : option.names) {
      text += fmt::format("    {}:{}) {} ;;\n", command.name, name, bash_call(option.candidates));
    }
  }
  return text;
}

/// A pattern for names with one of the endings. A single ending in parentheses would be parsed as
/// glob qualifiers.
std::string zsh_pattern(const std::vector<std::string>& endings) {
  if (endings.size() == 1) return "\\*." + endings[0];
  return fmt::format("\\*.\\({}\\)", fmt::join(endings, "\\|"));
}

std::string zsh_action(const Candidates& candidates) {
  switch (candidates.kind) {
    case Kind::none:
      return " ";
    case Kind::words:
      return "(" + joined(candidates.words) + ")";
    case Kind::list:
      return "_values -s , name " + joined(candidates.words);
    case Kind::file:
      return "_files";
    case Kind::folder:
      return "_files -/";
    case Kind::scene:
      return "{ _alternative \"scenes:scene:(" + joined(candidates.words) +
             ")\" \"files:file:_files -g " + zsh_pattern(candidates.endings) + "\" }";
  }
  return {};
}

/// Escapes the characters that end a description or a message of _arguments.
std::string zsh_text(const std::string& text) {
  return replaced(replaced(replaced(text, "[", "\\["), "]", "\\]"), ":", "\\:");
}

std::string zsh_option(const Option& option) {
  std::string value;
  if (!option.placeholder.empty()) {
    value = fmt::format(":{}:{}", zsh_text(option.placeholder), zsh_action(option.candidates));
  }
  const std::string others = option.names.size() > 1 ? "(" + joined(option.names) + ")" : "";
  std::string text;
  for (const std::string& name : option.names) {
    const char* const equals = !value.empty() && name.starts_with("--") ? "=" : "";
    const std::string specification =
        fmt::format("{}{}{}[{}]{}", others, name, equals, zsh_text(option.help), value);
    text += fmt::format("        {} \\\n", quoted(specification));
  }
  return text;
}

/// Uses a single list, because fish keeps only the last of several.
std::string fish_scenes(const Candidates& candidates) {
  std::string files;
  for (const auto& end : candidates.endings) files += "(__fish_complete_suffix ." + end + ") ";
  return "-x -a " + quoted(files + joined(candidates.words));
}

std::string fish_candidates(const Candidates& candidates) {
  switch (candidates.kind) {
    case Kind::none:
      return "-x";
    case Kind::words:
      return "-x -a " + quoted(joined(candidates.words));
    case Kind::list:
      return "-x -a " + quoted("(__twrench_list " + joined(candidates.words) + ")");
    case Kind::file:
      return "-r -F";
    case Kind::folder:
      return "-x -a " + quoted("(__fish_complete_directories)");
    case Kind::scene:
      return fish_scenes(candidates);
  }
  return {};
}

std::string fish_option(const std::string& condition, const Option& option) {
  std::string names;
  for (const std::string& name : option.names) {
    names += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  const std::string value =
      option.placeholder.empty() ? "" : " " + fish_candidates(option.candidates);
  return fmt::format("complete -c twrench {}{}{} -d {}\n", condition, names, value,
                     quoted(option.help));
}

}  // namespace

std::string bash_completion(const Command& program, const std::vector<Command>& commands) {
  std::string values, arguments, options;
  for (const Command& command : commands) {
    values += bash_cases(command);
    options += fmt::format("    {}) _twrench_words {} ;;\n", command.name,
                           quoted(joined(option_names(command))));
    if (command.arguments.empty()) continue;
    arguments += fmt::format("    {}) {} ;;\n", command.name,
                             bash_call(command.arguments.front().candidates));
  }
  return fmt::format(R"(# bash completion for twrench

_twrench_words() {{
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$current")
}}

# Completes the last of several words that are separated by commas.
_twrench_list() {{
  local before=
  [[ $current == *,* ]] && before=${{current%,*}},
  mapfile -t COMPREPLY < <(compgen -P "$before" -W "$1" -- "${{current##*,}}")
  compopt -o nospace
}}

_twrench_files() {{
  compopt -o filenames
  mapfile -t COMPREPLY < <(compgen "$1" -- "$current")
}}

_twrench_scenes() {{
  compopt -o filenames
  mapfile -t COMPREPLY < <(
    compgen -W "$1" -- "$current"
    for ending in $2; do compgen -f -X "!*.$ending" -- "$current"; done
    compgen -d -- "$current"
  )
}}

_twrench() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}}
  local command=${{COMP_WORDS[1]}}
  # bash takes the equals sign of --name=value for a word.
  [[ $current == = ]] && current=
  [[ $previous == = ]] && previous=${{COMP_WORDS[COMP_CWORD - 2]}}
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    _twrench_words {}
    return
  fi
  case $command:$previous in
{}    *) _twrench_rest ;;
  esac
}}

# Completes an option, or an argument of the command.
_twrench_rest() {{
  if [[ $current == -* ]]; then
    case $command in
{}    esac
    return
  fi
  case $command in
{}  esac
}}

complete -F _twrench twrench
)",
                     quoted(joined(names_of(commands)) + " " + joined(option_names(program))),
                     values, options, arguments);
}

std::string zsh_completion(const Command& program, const std::vector<Command>& commands) {
  std::string descriptions, cases, options;
  for (const Option& option : program.options) options += zsh_option(option);
  for (const Command& command : commands) {
    descriptions +=
        fmt::format("    {}\n", quoted(zsh_text(command.name) + ":" + command.description));
    cases += fmt::format("    {})\n      _arguments -s \\\n", command.name);
    for (const Option& option : command.options) cases += zsh_option(option);
    for (const Option& argument : command.arguments) {
      cases += fmt::format("        {} \\\n",
                           quoted(fmt::format(":{}:{}", zsh_text(argument.names.front()),
                                              zsh_action(argument.candidates))));
    }
    cases += "      ;;\n";
  }
  return fmt::format(R"(#compdef twrench

local -a commands
commands=(
{})
_arguments -C \
{}        '1: :->command' \
        '*:: :->arguments'
case $state in
  command) _describe command commands ;;
  arguments)
    case $words[1] in
{}    esac
    ;;
esac
)",
                     descriptions, options, cases);
}

std::string fish_completion(const Command& program, const std::vector<Command>& commands) {
  std::string text = R"(# fish completion for twrench

# Completes the last of several words that are separated by commas.
function __twrench_list
    set -l before (string match -r '^.*,' -- (commandline -ct | string replace -r '^--[^=]*=' ''))
    for word in $argv
        echo "$before$word"
    end
end

complete -c twrench -f
)";
  for (const Option& option : program.options) {
    text += fish_option("-n __fish_use_subcommand", option);
  }
  for (const Command& command : commands) {
    text += fmt::format("complete -c twrench -n __fish_use_subcommand -a {} -d {}\n", command.name,
                        quoted(command.description));
    const std::string condition = "-n " + quoted("__fish_seen_subcommand_from " + command.name);
    for (const Option& option : command.options) text += fish_option(condition, option);
    if (command.arguments.empty()) continue;
    const Candidates& candidates = command.arguments.front().candidates;
    if (candidates.kind == Kind::none) continue;
    text += fmt::format("complete -c twrench {} {}\n", condition,
                        candidates.kind == Kind::file ? "-F" : fish_candidates(candidates));
  }
  return text;
}

}  // namespace twrench::manual

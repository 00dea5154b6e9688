#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/options/command_line.h"

namespace twrench::app {

/// The completions that a shell offers for the value of an option or argument.
struct Candidates {
  enum class Kind {
    none,    ///< Nothing.
    words,   ///< One of `words`.
    list,    ///< One or several of `words`, separated by commas.
    file,    ///< A file.
    folder,  ///< A folder.
    scene,   ///< One of `words`, or a file with one of `endings`.
  };
  Kind kind = Kind::none;
  std::vector<std::string> words = {};
  /// File name extensions, such as "toml".
  std::vector<std::string> endings = {};
};

/// An option or a positional argument of a command.
struct Option {
  /// "-o" and "--output"; the name of an argument.
  std::vector<std::string> names;
  /// The placeholder for the value in help; empty for a flag and for an argument.
  std::string placeholder;
  std::string help;
  /// The default that applies, or empty.
  std::string otherwise;
  Candidates candidates;
  /// Nothing for an argument.
  std::optional<OptionGroup> group = {};
};

/// A command, as described by --help, the manual pages and the shell completions.
struct Command {
  std::string name;
  std::string description;
  std::vector<Option> arguments;
  std::vector<Option> options;
  /// How an argument is written in the synopsis, such as "[SCENE]", in order.
  std::vector<std::string> usage;
  /// The lines below the options in --help.
  std::string footer;
};

/// Returns a command or, for the program itself, its own options. Throws std::logic_error if an
/// option names no group.
Command read_command(const CLI::App& app);

/// Returns the commands of the program, in the order of --help.
std::vector<Command> read_commands(const CLI::App& app);

/// Returns the placeholder for the value of an option in help and messages, such as "FILE".
std::string placeholder_of(const CLI::Option& option);

}  // namespace twrench::app

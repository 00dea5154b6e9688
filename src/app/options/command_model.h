#pragma once

#include <string>
#include <vector>

#include "app/options/command_line.h"

namespace twrench::app {

/// What a shell can offer as the value of an option or argument.
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
  /// The ends of the names of files, such as "toml".
  std::vector<std::string> endings = {};
};

/// An option or a positional argument of a command.
struct Option {
  /// "-o" and "--output"; the name of an argument.
  std::vector<std::string> names;
  /// What stands for the value in help; empty for a flag and for an argument.
  std::string placeholder;
  std::string help;
  /// The default that applies, or empty.
  std::string otherwise;
  Candidates candidates;
};

/// A command, as --help, the manual pages and the shell completions tell of it.
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

/// Returns a command; of the program itself, its own options.
Command read_command(const CLI::App& app);

/// Returns the commands of the program, in the order of --help.
std::vector<Command> read_commands(const CLI::App& app);

/// Returns what stands for the value of an option in help and messages, such as "FILE".
std::string placeholder_of(const CLI::Option& option);

}  // namespace twrench::app

#pragma once

#include <map>
#include <string>
#include <vector>

#include "dice.h"

namespace twrench::torture {

/// A command line and its known properties.
struct CommandLine {
  std::vector<std::string> words;  ///< without the program
  std::string command;             ///< "" if there is none, or an unknown one
  /// given options, by their long names without dashes
  std::map<std::string, std::string> options;
  /// positional arguments
  std::vector<std::string> arguments;
  /// see Value
  bool may_last = false;
  /// scene file that the program reads from a pipe, as /dev/stdin
  std::string piped_scene;
  /// two of its outputs are the same file
  bool has_one_output_twice = false;
  /// ffmpeg and ffprobe print warnings
  bool has_loud_children = false;
  /// malformed: its meaning is unknown
  bool is_odd = false;

  bool has(const std::string& option) const { return options.contains(option); }
  std::string value(const std::string& option, const std::string& otherwise = {}) const;
};

/// An option of a command, from the program's own table.
struct Option {
  std::string name;  ///< long name without dashes; for an argument, its name in the usage
  bool is_argument = false;
  bool is_flag = false;
  bool is_required = false;
};

using OptionTable = std::map<std::string, std::vector<Option>>;  ///< by command

/// Reads the table with which the program parses its command line.
OptionTable read_option_table();

/// Returns a random command line for one of these commands, usually one that the program may
/// accept, with one or two hostile values. Limits on size and time are prepended to keep runs
/// small.
CommandLine random_command_line(const OptionTable& table, Dice& dice);

}  // namespace twrench::torture

#pragma once

#include <map>
#include <string>
#include <vector>

#include "dice.h"

namespace twrench::torture {

/// A command line, and what is known of it.
struct CommandLine {
  std::vector<std::string> words;              ///< without the program
  std::string command;                         ///< "" where there is none, or an unknown one
  std::map<std::string, std::string> options;  ///< what was given, by the long name without dashes
  std::vector<std::string> arguments;          ///< those that are not options
  bool may_last = false;                       ///< see Value
  bool is_odd = false;  ///< not put together as a command line is: its meaning is not known here

  bool has(const std::string& option) const { return options.contains(option); }
  std::string value(const std::string& option, const std::string& otherwise = {}) const;
};

/// An option of a command, as the program's own table has it.
struct Option {
  std::string name;  ///< long, without dashes; of an argument, as its usage has it
  bool is_argument = false;
  bool is_flag = false;
  bool is_required = false;
};

using OptionTable = std::map<std::string, std::vector<Option>>;  ///< by command

/// From what the program itself parses its command line with.
OptionTable read_option_table();

/// A random command line of these commands: mostly such as the program may accept, with one or two
/// hostile values. Bounds on size and time are put before, for a run to be small.
CommandLine random_command_line(const OptionTable& table, Dice& dice);

}  // namespace twrench::torture

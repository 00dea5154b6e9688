#pragma once

#include <twrench/base/error.h>

#include <string>
#include <vector>

#include "app/options/command_line.h"

namespace twrench::app {

/// Makes --help of a command, and of the subcommands that are added to it later, independent of the
/// CLI11 release: each option with its value and its default.
void set_help_format(CLI::App& app);

/// Puts --help into its group, and adds --help-all to each command with more than 20 options. Their
/// --help describes the ten most used ones and lists the others by groups. Call this after all
/// options are added.
void add_help_all(CLI::App& app);

/// Adds `twrench help [COMMAND]`, which prints the same as --help.
void add_help(CLI::App& app);

/// Returns the arguments in the order that CLI11 expects, the last first. "--name=" becomes
/// "--name" and an empty word, because some CLI11 releases would take the next word as its value;
/// "--fit inertia" becomes "--fit=inertia", because --fit needs no value and may precede a file.
std::vector<std::string> words_for_parser(int argc, const char* const* argv);

/// Makes an empty value a usage error, because scripts pass one from an unset variable; a title may
/// be empty. So is a value of an option that takes none, except true and false. Call this after all
/// options are added.
void refuse_meaningless_values(CLI::App& app);

/// Returns our error message for a command line that `app` could not parse, independently of the
/// CLI11 release; suggests the nearest option for an unknown one.
InvalidArgument usage_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace twrench::app

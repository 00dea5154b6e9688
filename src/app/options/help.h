#pragma once

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

}  // namespace twrench::app

#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace twrench::app {

/// Formats --help independently of the CLI11 release, with each option, its value and its default.
class Help : public CLI::FormatterBase {
 public:
  std::string make_help(const CLI::App* command, std::string name,
                        CLI::AppFormatMode mode) const override;
};

/// Adds `twrench help [COMMAND]`, which prints the same as --help.
void add_help(CLI::App& app);

}  // namespace twrench::app

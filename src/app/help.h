#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace twrench {

/// How --help looks, whatever release of CLI11 there is: each option with its value and its default
/// on a line.
class Help : public CLI::FormatterBase {
 public:
  std::string make_help(const CLI::App* command, std::string name,
                        CLI::AppFormatMode mode) const override;
};

/// Adds `twrench help [COMMAND]`, which prints what --help prints.
void add_help(CLI::App& app);

}  // namespace twrench

#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/options/command_line.h"
#include "recording/conventions/convention.h"

namespace twrench::app {

/// Returns the name of the option that gives a field or a key.
std::string name_of_option(const std::string& key);

/// The options that determine how a recording is read: one for each field of a convention. Must
/// live as long as the command.
class ConventionOptions {
 public:
  void add_to(CLI::App& command);

  /// Returns the values of the options that were given, by the names of their fields. Throws
  /// InvalidArgument.
  nlohmann::ordered_json values() const;

  /// Returns how a recording is to be read, as far as the options determine it. Throws
  /// InvalidArgument.
  recording::Convention convention() const;

  /// Returns the options that were given, as words of a command line.
  std::vector<std::string> given() const;

 private:
  void add_option(CLI::App& command, const recording::Field& field);

  // The values of the fields, by their names.
  std::map<std::string, std::string> texts_;
  std::map<std::string, bool> flags_;
};

}  // namespace twrench::app

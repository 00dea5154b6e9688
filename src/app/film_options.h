#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "movie/encode_frames.h"

namespace twrench {

/// The options that say where a film goes, and in which container.
struct FilmOptions {
  /// Adds --output and --container. `standard` is said to be the default, where there is one.
  void add_to(CLI::App& command, const std::string& standard);

  bool is_streamed() const { return output == "-"; }

  /// The container that was named, or that the film's name ends with. Throws UsageError.
  Container container(const std::filesystem::path& film) const;

  /// Throws UsageError where standard output is to be the film and cannot be: it is a terminal, or
  /// `progress` has it.
  void require_free_output(const std::string& progress) const;

  std::string output;          ///< a file, "-", or empty
  std::string container_name;  ///< may be empty
};

}  // namespace twrench

#pragma once

#include <string>

#include "app/options/command_line.h"
#include "system/file_list.h"

namespace twrench::app {

/// Adds the option --overwrite for files that are not twrench's.
void add_overwrite_option(CLI::App& command, bool& overwrite);

/// The options of what a command writes: -o, --overwrite and, if it has several formats, --format.
/// Must live as long as the command.
class OutputOptions {
 public:
  /// The output of a command without -o.
  enum class Otherwise { standard_output, none };

  OutputOptions(CLI::App& command, const system::OutputKind& kind,
                Otherwise otherwise = Otherwise::standard_output);

  /// Returns an empty list. The command adds every file that it reads or writes.
  system::FileList files() const { return system::FileList(overwrite_); }

  /// Adds the output to the list. Throws as FileList::add_output().
  system::OutputFile add_to(system::FileList& files) const { return add_to(files, kind_); }

  /// The same for an output of another kind, with the same formats.
  system::OutputFile add_to(system::FileList& files, const system::OutputKind& kind) const {
    return files.add_output(kind, path_, format_);
  }

  /// Returns the output as it was given.
  const std::string& path() const { return path_; }

 private:
  const system::OutputKind& kind_;
  std::string path_ = "-", format_;
  bool overwrite_ = false;
};

}  // namespace twrench::app

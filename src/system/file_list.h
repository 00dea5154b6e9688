#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "system/error.h"
#include "system/output_kind.h"

namespace twrench::system {

/// A file that a command may write. Only a FileList gives it, so that no output can forget the
/// checks.
class OutputFile {
 public:
  /// A file, or "-" for standard output.
  const std::filesystem::path& path() const { return path_; }
  const OutputFormat& format() const { return *format_; }

 private:
  friend class FileList;
  OutputFile(std::filesystem::path path, const OutputFormat& format)
      : path_(std::move(path)), format_(&format) {}

  std::filesystem::path path_;
  const OutputFormat* format_;
};

/// The files that a command reads and writes, also those that its user did not name. An input is
/// never an output, and two outputs are never one file, under any names and through any links. Fill
/// the list before the first byte is written. Devices and pipes can be shared.
class FileList {
 public:
  /// Whether outputs may replace files that are not twrench's, or of another kind.
  explicit FileList(bool overwrite = false) : overwrite_(overwrite) {}

  /// Adds an input; a file that does not exist is none. Throws OverwriteError if it is an output.
  void add_input(const std::filesystem::path& file);

  /// Adds an output. Throws InvalidArgument as format_of() does, and OverwriteError if the file is
  /// an input or another output, or exists and may not be replaced, FileError if its folder
  /// exists and is not writable.
  OutputFile add_output(const OutputKind& kind, const std::filesystem::path& file,
                        std::string_view format = {});

  /// Adds an output whose old contents are protected elsewhere, such as a video or a folder. Throws
  /// OverwriteError if it is an input or another output.
  void add_output(const std::filesystem::path& file);

  /// Adds the files in a folder whose names `is_output` accepts as outputs. Throws OverwriteError.
  void add_outputs(const std::filesystem::path& folder,
                   std::function<bool(const std::string& name)> is_output);

 private:
  enum class Role { input, output };
  struct Entry {
    std::filesystem::path path;
    Role role;
  };
  struct Folder {
    std::string place;
    std::function<bool(const std::string& name)> is_output;
  };

  void add(const std::filesystem::path& file, Role role);

  bool overwrite_;
  std::map<std::string, Entry> files_;  ///< By each of the names that identify a file.
  std::vector<Folder> folders_;
};

}  // namespace twrench::system

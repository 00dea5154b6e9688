#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "system/error.h"
#include "system/pending_file.h"

namespace twrench::system {

/// A format of an output.
struct OutputFormat {
  /// The value of --format, and of `format` in Python.
  std::string_view name;
  /// The endings of its files; the first is the usual one, and an empty one is none.
  std::array<std::string_view, 2> endings;
  /// The first bytes of a file that twrench wrote.
  std::string_view begins;
  /// A text near the beginning or the end of such a file, which other files lack.
  std::string_view mark;
  /// Whether a terminal cannot show it.
  bool is_binary = false;
};

/// A kind of output. The table of its formats serves the choice of the format, the protection of
/// existing files and the help.
struct OutputKind {
  /// The name in messages.
  std::string_view name;
  /// The first one is the default.
  std::span<const OutputFormat> formats;
  /// How the format is chosen for a file without an ending, and for standard output.
  enum class Choice {
    by_default,  ///< By its name, or the default.
    by_name,     ///< By its name, which is needed then.
    by_ending,   ///< A name must have an ending; standard output gets the default.
    files_only,  ///< A name must have an ending; standard output is refused.
  };
  Choice choice = Choice::by_default;

  bool has_format_option() const {
    return formats.size() > 1 && (choice == Choice::by_default || choice == Choice::by_name);
  }
};

extern const OutputKind motion_output, saved_motion, exported_motion, inertia_output, robot_output,
    robot_page, robot_file, check_output, study_output, list_of_cases, case_output, schema_output,
    plot_output, page_output, index_output, report_output, comparison_page, difference_picture;

/// Returns ".svg, .pdf or .png".
std::string listed_endings(const OutputKind& kind);

/// Returns "svg, pdf or png".
std::string listed_names(const OutputKind& kind);

/// Returns the format of `file`: that with `name` or, if `name` is empty, that of the ending.
/// Throws InvalidArgument if no format, or another one than the named one, has this ending.
const OutputFormat& format_of(const OutputKind& kind, const std::filesystem::path& file,
                              std::string_view name = {});

/// Returns whether twrench wrote the regular file in this format.
bool is_written_in(const OutputFormat& format, const std::filesystem::path& file);

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

/// Writes a command's data to a file, atomically, or to standard output for "-". Data is written in
/// pieces, so that it is never held in memory as a whole.
class Output {
 public:
  /// Writes to standard output.
  Output() = default;

  /// Throws FileError.
  explicit Output(const OutputFile& file);

  /// Throws FileError.
  void write(std::string_view text);

  /// Call this once after the last piece; otherwise a file keeps its old content. Throws FileError.
  void finish();

 private:
  void pass_on();

  std::optional<PendingFile> file_;  ///< Empty for standard output.
  std::string waiting_;              ///< Small pieces are written together.
};

/// Writes data that is already complete. Throws FileError.
void write_output(const OutputFile& file, std::string_view text);

/// Writes data to standard output. Throws FileError.
void write_output(std::string_view text);

}  // namespace twrench::system

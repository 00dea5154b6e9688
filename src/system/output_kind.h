#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

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

extern const OutputKind motion_output, saved_motion, exported_motion, inertia_output, check_output,
    study_output, list_of_cases, case_output, schema_output, plot_output, page_output, index_output,
    report_output, comparison_page, difference_picture;

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

}  // namespace twrench::system

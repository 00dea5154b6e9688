#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "app/options/command_line.h"
#include "scene/limits.h"
#include "system/output.h"

namespace twrench::app {

// Conversions of command-line arguments to values. Each throws InvalidArgument about `what`, the
// option. Numbers use '.' in every locale. Functions without a limit leave the check of the range
// to the caller.

/// Splits "A,B,..." at the commas.
std::vector<std::string> parse_words(const std::string& text);

double parse_number(const std::string& text, const std::string& what);

/// Parses a number, or an integer, and checks it against its limit.
double parse_number(const std::string& text, const std::string& what,
                    const scene::limits::Limit& limit);

int parse_whole(const std::string& text, const std::string& what,
                const scene::limits::Limit& limit);

/// Parses "T1,T2,...".
std::vector<double> parse_numbers(const std::string& text, const std::string& what);

/// Parses "X,Y,Z".
Eigen::Vector3d parse_vector(const std::string& text, const std::string& what);

/// Parses "W,X,Y,Z", a quaternion.
Eigen::Vector4d parse_quaternion(const std::string& text, const std::string& what);

/// Parses "A,B,C", principal moments about the body's axes, or "Ixx,Iyy,Izz,Ixy,Ixz,Iyz", the
/// entries of an inertia matrix in the order of MuJoCo's `fullinertia`, in g cm^2. Returns the
/// matrix within the limits of scene files.
Eigen::Matrix3d parse_inertia(const std::string& text, const std::string& what);

/// Parses "X,Y,Z;X,Y,Z;...".
std::vector<Eigen::Vector3d> parse_vectors(const std::string& text, const std::string& what);

/// Parses "WxH" without checking the values.
Eigen::Vector2d parse_size(const std::string& text, const std::string& what);

/// Returns the options with those names as they were given, as words of a command line.
std::vector<std::string> given_options(const CLI::App& command,
                                       const std::vector<std::string>& names);

/// Returns a check for CLI::Option that the value is one of `names`; it throws InvalidArgument if
/// not. Its description lists the names, "{csv,json}", and read_command() reads them from it.
CLI::Validator one_of(const std::string& what, std::vector<std::string> names);

/// Adds the option --format, which accepts one of `formats`; `format` is the default.
CLI::Option* add_format_option(CLI::App& command, std::string& format,
                               const std::vector<std::string>& formats);

/// Adds the option --progress for the style of Progress.
void add_progress_option(CLI::App& command, std::string& style);

/// Returns whether the command's style of progress is json; false for commands without the option.
bool is_progress_json(const CLI::App& command);

/// Adds the option --overwrite for files that are not twrench's.
void add_overwrite_option(CLI::App& command, bool& overwrite);

/// Throws InvalidArgument if standard output, for bytes that are no text, is a terminal. `example`
/// may end the remedy.
void require_no_terminal(const std::string& example = {});

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

  /// Adds the output to the list. Throws as FileList::add_output(), and InvalidArgument for a
  /// format that the terminal cannot show.
  system::OutputFile add_to(system::FileList& files) const { return add_to(files, kind_); }

  /// The same for an output of another kind, with the same formats.
  system::OutputFile add_to(system::FileList& files, const system::OutputKind& kind) const;

  /// Returns the output as it was given.
  const std::string& path() const { return path_; }

 private:
  const system::OutputKind& kind_;
  std::string path_ = "-", format_;
  bool overwrite_ = false;
};

}  // namespace twrench::app

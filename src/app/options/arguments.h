#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "app/options/command_line.h"
#include "scene/limits.h"

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

}  // namespace twrench::app

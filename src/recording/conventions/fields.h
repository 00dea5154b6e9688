#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "recording/conventions/convention.h"

namespace twrench::recording {

/// The value of a field: whether a flag is set, a word (empty if there is none), our names and the
/// file's, or a rotation. Nothing stands for a rotation that is not there.
using FieldValue = std::variant<std::monostate, bool, std::string,
                                std::map<std::string, std::string>, Eigen::Quaterniond>;

/// How users give a field.
enum class FieldForm { flag, text, rotation, unasked };

/// A field of Convention. The options of the program, the arguments of Python, the reports and the
/// search for other conventions all follow from the table of the fields.
struct Field {
  const char* name;  ///< of the argument, and in the JSON: "angle_units"
  FieldForm form;
  std::string help;
  const char* placeholder;         ///< for the value, in the help
  const char* otherwise;           ///< what holds if it is not given; may be empty
  std::vector<std::string> words;  ///< the only ones allowed; empty if there is no such list

  std::function<FieldValue(const Convention&)> value;
  /// Throws InvalidArgument about the argument of this name. Empty if users are not asked.
  std::function<void(Convention&, const FieldValue&)> set;
  /// What the field says, for a person: "the rates are in deg/s".
  std::function<std::string(const Convention&)> statement;
};

/// All fields, in the order in which users read them.
const std::vector<Field>& convention_fields();

/// Whether both have the same value in this field. Rotations may differ by rounding.
bool agree(const Field& field, const Convention& a, const Convention& b);

/// Mentions the argument that gives the field the value that it has in the convention:
/// `--angle-units deg`. Empty for a flag that is not set, for no value, and if users are not asked.
std::string mention(const Field& field, const Convention& convention);

/// The arguments that change the first convention into the second: `--units deg --inverse`.
std::string changing_arguments(const Convention& before, const Convention& after);

}  // namespace twrench::recording

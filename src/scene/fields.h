#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace twrench::scene {

/// One value of a scene, with its place in a scene file. Reading a scene file, the scene's JSON,
/// and the options of the program with their help are all made from these. The body is not among
/// them: its tables are read by themselves.
struct Field {
  /// The form of a value in TOML and in JSON.
  enum class Kind {
    number,   ///< A number.
    integer,  ///< A number without a fraction.
    vector,   ///< An array of three numbers.
    size,     ///< An array of two integers: width and height.
    text,     ///< A string.
    texts,    ///< An array of strings.
    vectors,  ///< An array of arrays of three numbers.
  };

  /// Name of the table; empty for the top level of the file.
  std::string table;
  /// Name of the key in that table.
  std::string key;
  /// What stands for the value in help, such as "X,Y,Z".
  std::string placeholder;
  /// What the value means, with its unit: a line of help.
  std::string help;
  /// Describes the default; empty if it is the value of Scene().
  std::string otherwise = {};
  Kind kind = Kind::number;
  /// Sets the value. `value` must have the form of `kind`. Throws InvalidArgument about `what` if
  /// the value is not allowed.
  std::function<void(Scene&, const nlohmann::ordered_json& value, const std::string& what)> set =
      {};
  /// Returns the value, or null if the scene leaves it to `otherwise`.
  std::function<nlohmann::ordered_json(const Scene&)> get = {};
};

/// Returns all fields, in the order in which documents and help list them.
const std::vector<Field>& fields();

/// Returns the names of the tables that hold fields, in their order.
std::vector<std::string> field_tables();

/// Returns the vector in a value of the form Kind::vector.
Eigen::Vector3d to_vector(const nlohmann::ordered_json& value);

}  // namespace twrench::scene

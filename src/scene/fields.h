#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/value_form.h"

namespace twrench::scene {

/// One value of a scene, with its place in a scene file. The reader of scene files, the JSON of
/// scenes, the options of the program with their help, and the schema are all derived from the
/// fields. The body and the shots have no fields: see keys.h.
struct Field {
  /// Name of the table; empty for the top level of the file.
  std::string table;
  /// Name of the key in that table.
  std::string key;
  /// The placeholder for the value in help, such as "X,Y,Z".
  std::string placeholder;
  /// The meaning of the value, with its unit, as a line of help.
  std::string help;
  /// Describes the default; empty if it is the value of Scene().
  std::string otherwise = {};
  ValueForm form = {};
  /// Sets the value. `value` must have the form of `form.kind`. Throws InvalidArgument about `what`
  /// if the value is not allowed.
  std::function<void(Scene&, const nlohmann::ordered_json& value, const std::string& what)> set =
      {};
  /// Returns the value, or null if the scene leaves it to `otherwise`.
  std::function<nlohmann::ordered_json(const Scene&)> get = {};
};

/// Returns all fields, in the order in which documents and help list them.
const std::vector<Field>& fields();

/// Returns the names of the tables that hold fields, in their order.
std::vector<std::string> field_tables();

/// Returns the vector in a value of the form ValueForm::Kind::vector.
Eigen::Vector3d to_vector(const nlohmann::ordered_json& value);

/// Returns the four numbers in a value of the form ValueForm::Kind::quaternion.
Eigen::Vector4d to_quaternion(const nlohmann::ordered_json& value);

}  // namespace twrench::scene

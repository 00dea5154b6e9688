#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "scene/value_form.h"

// The keys that are no fields: those of [[part]], [body] and [[shot]], and those of [motion] that
// name a recording. The reader takes their limits and names from here, and the schema and the
// manual page are generated from them.

namespace twrench::scene {

/// A key of a table.
struct Key {
  std::string name;
  /// The meaning of the value, with its unit.
  std::string help;
  ValueForm form;
  /// Describes the default; empty if `value` is the default, or if there is none.
  std::string otherwise = {};
  /// The default, if it is a value; otherwise null.
  nlohmann::ordered_json value = {};
  bool is_required = false;
  /// The key that gives the same quantity in another way; the two exclude each other.
  std::string instead_of = {};
};

/// Returns the keys of [[part]] that are common to all shapes.
const std::vector<Key>& part_keys();

/// The keys of [[part]] that depend on its shape.
struct ShapeKeys {
  /// The name of the shape.
  std::string shape;
  /// Its dimensions; for a mesh, the file and how it is read.
  std::vector<Key> keys;
};

/// Returns the keys of a mesh.
const std::vector<Key>& mesh_keys();

/// Returns the keys of each shape.
const std::vector<ShapeKeys>& shape_keys();

/// Returns the keys of [body].
const std::vector<Key>& body_keys();

/// Returns the keys of [[shot]] that are neither tables nor arrays of tables.
const std::vector<Key>& shot_keys();

/// Returns the keys of [motion] that name a recorded motion: its file, the rows that are shown, and
/// the fields of recording::Convention.
const std::vector<Key>& recording_keys();

/// The limits of the components of a quaternion, whose length is 1 within 0.1.
inline constexpr limits::Limit unit_quaternion{-1.1, 1.1};

/// The key without which the other recording_keys() have no meaning.
inline constexpr const char* recording_file_key = "file";

/// The keys of [motion] that a recorded motion excludes.
inline constexpr std::array keys_of_computed_motions{"omega", "method"};

/// The `start` of a shot that shows the body as the previous one ended.
inline constexpr const char* match_name = "match";

/// The tables of fields that a shot may have. The fields of the others are the film's.
inline constexpr std::array field_tables_of_shots{"motion", "look", "camera", "overlay"};

/// Returns the key with that name, which must be one of `keys`.
const Key& key_named(const std::vector<Key>& keys, std::string_view name);

}  // namespace twrench::scene

#include "scene/scene_schema.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <nlohmann/json.hpp>

#include "scene/fields.h"
#include "scene/keys.h"
#include "scene/limits.h"

namespace twrench::scene {
namespace {

using nlohmann::ordered_json;

ordered_json with_limit(ordered_json schema, const std::optional<limits::Limit>& limit) {
  if (!limit) return schema;
  schema["minimum"] = limit->low;
  schema["maximum"] = limit->high;
  return schema;
}

ordered_json array_schema(ordered_json items, std::size_t least, std::optional<std::size_t> most) {
  ordered_json schema{{"type", "array"}, {"items", std::move(items)}};
  if (least > 0) schema["minItems"] = least;
  if (most) schema["maxItems"] = *most;
  return schema;
}

ordered_json text_schema(const ValueForm& form) {
  if (form.names.empty()) return {{"type", "string"}};
  const ordered_json names{{"enum", form.names}};
  if (!form.is_color) return names;
  const ordered_json digits{{"pattern", "^#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})$"}};
  return {{"type", "string"}, {"anyOf", {names, digits}}};
}

ordered_json value_schema(const ValueForm& form) {
  const auto numbers = [&](const char* type, std::size_t count) {
    return array_schema(with_limit({{"type", type}}, form.limit), count, count);
  };
  switch (form.kind) {
    case ValueForm::Kind::number:
      return with_limit({{"type", "number"}}, form.limit);
    case ValueForm::Kind::integer:
      return with_limit({{"type", "integer"}}, form.limit);
    case ValueForm::Kind::rate:
      return {{"anyOf",
               {with_limit({{"type", "number"}}, form.limit),
                {{"type", "string"}, {"pattern", "^[0-9]+/[0-9]+$"}}}}};
    case ValueForm::Kind::vector:
      return numbers("number", 3);
    case ValueForm::Kind::quaternion:
      return numbers("number", 4);
    case ValueForm::Kind::size:
      return numbers("integer", 2);
    case ValueForm::Kind::text:
      return text_schema(form);
    case ValueForm::Kind::texts:
      return array_schema(text_schema(form), form.least, form.most);
    case ValueForm::Kind::vectors:
      return array_schema(numbers("number", 3), form.least, form.most);
    case ValueForm::Kind::flag:
      return {{"type", "boolean"}};
  }
  return {};
}

/// "Step size, s. Default: the time of a turn."
std::string description(std::string help, const std::string& otherwise) {
  help[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(help[0])));
  return otherwise.empty() ? help + "." : fmt::format("{}. Default: {}.", help, otherwise);
}

ordered_json field_schema(const Field& field) {
  ordered_json schema{{"description", description(field.help, field.otherwise)}};
  schema.update(value_schema(field.form));
  return schema;
}

/// The schema of a field of the film. A shot has the film's value by default.
ordered_json field_schema_with_default(const Field& field) {
  ordered_json schema = field_schema(field);
  ordered_json value = field.get(Scene());
  if (field.otherwise.empty() && value != "") schema["default"] = std::move(value);
  return schema;
}

ordered_json key_schema(const Key& key) {
  ordered_json schema{{"description", description(key.help, key.otherwise)}};
  schema.update(value_schema(key.form));
  if (!key.value.is_null()) schema["default"] = key.value;
  return schema;
}

/// A table with these keys and no others.
ordered_json table_schema(std::string description, ordered_json properties) {
  return {{"description", std::move(description)},
          {"type", "object"},
          {"properties", std::move(properties)},
          {"additionalProperties", false}};
}

ordered_json array_of_tables(const char* table, std::size_t most) {
  return array_schema({{"$ref", table}}, 1, most);
}

ordered_json required(const std::vector<std::string>& keys) { return {{"required", keys}}; }

std::vector<std::string> required_keys(const std::vector<Key>& keys) {
  std::vector<std::string> names;
  for (const Key& key : keys) {
    if (key.is_required) names.push_back(key.name);
  }
  return names;
}

ordered_json key_properties(const std::vector<Key>& keys) {
  ordered_json properties = ordered_json::object();
  for (const Key& key : keys) properties[key.name] = key_schema(key);
  return properties;
}

/// Adds the keys that depend on the shape. A key has the same form in all shapes that share it.
void add_shape_properties(ordered_json& properties) {
  for (const ShapeKeys& shape : shape_keys()) {
    for (const Key& key : shape.keys) {
      std::vector<std::string> shapes;
      for (const ShapeKeys& other : shape_keys()) {
        const bool has_key =
            std::ranges::find(other.keys, key.name, &Key::name) != other.keys.end();
        if (has_key) shapes.push_back(other.shape);
      }
      ordered_json schema = key_schema(key);
      schema["description"] = fmt::format(
          "{} Shapes: {}.", schema["description"].get<std::string>(), fmt::join(shapes, ", "));
      properties[key.name] = std::move(schema);
    }
  }
}

/// The keys that a part of this shape must have, and those that it may have.
ordered_json shape_rule(const ShapeKeys& shape) {
  std::vector<std::string> allowed;
  std::ranges::transform(part_keys(), std::back_inserter(allowed), &Key::name);
  std::ranges::transform(shape.keys, std::back_inserter(allowed), &Key::name);
  ordered_json condition = required({"shape"});
  condition["properties"]["shape"]["const"] = shape.shape;
  ordered_json rule = required(required_keys(shape.keys));
  rule["propertyNames"]["enum"] = allowed;
  return {{"if", std::move(condition)}, {"then", std::move(rule)}};
}

/// Forbids two keys of which one replaces the other.
void add_contradictions(ordered_json& rules, const std::vector<Key>& keys) {
  for (const Key& key : keys) {
    if (!key.instead_of.empty()) rules.push_back({{"not", required({key.instead_of, key.name})}});
  }
}

ordered_json one_of(const std::vector<std::string>& keys) {
  ordered_json schemas = ordered_json::array();
  for (const std::string& key : keys) schemas.push_back(required({key}));
  return {{"oneOf", std::move(schemas)}};
}

ordered_json part_schema() {
  ordered_json properties = key_properties(part_keys());
  add_shape_properties(properties);
  ordered_json schema = table_schema("A homogeneous solid of the body", std::move(properties));
  schema.update(required(required_keys(part_keys())));
  ordered_json rules = ordered_json::array();
  for (const ShapeKeys& shape : shape_keys()) rules.push_back(shape_rule(shape));
  rules.push_back(one_of({"density", "mass"}));
  add_contradictions(rules, part_keys());
  add_contradictions(rules, mesh_keys());
  schema["allOf"] = std::move(rules);
  return schema;
}

ordered_json body_schema() {
  ordered_json schema =
      table_schema("The body, given by its inertia instead of parts", key_properties(body_keys()));
  schema.update(one_of({"moments", "inertia"}));
  return schema;
}

/// A number, or pairs of a time in the shot and the speed at that time.
ordered_json shot_speed_schema() {
  ordered_json schema = key_schema(key_named(shot_keys(), "speed"));
  const ordered_json number = with_limit({{"type", "number"}}, limits::shot_speed);
  const ordered_json time = with_limit({{"type", "number"}}, limits::shot_transition);
  const ordered_json pair{
      {"type", "array"}, {"prefixItems", {time, number}}, {"minItems", 2}, {"maxItems", 2}};
  return {{"description", schema["description"]},
          {"anyOf", {number, array_schema(pair, 1, std::nullopt)}}};
}

/// A time, or the name of the time at which the shot matches the previous one.
ordered_json shot_start_schema() {
  ordered_json schema = key_schema(key_named(shot_keys(), "start"));
  return {
      {"description", schema["description"]},
      {"anyOf", {with_limit({{"type", "number"}}, limits::shot_start), {{"const", match_name}}}}};
}

/// The keys of a table that a shot may have. The font is the film's.
ordered_json fields_of_shots(const std::string& table) {
  ordered_json properties = ordered_json::object();
  for (const Field& field : fields()) {
    if (field.table == table && field.key != "font") properties[field.key] = field_schema(field);
  }
  return properties;
}

/// Adds the keys that name a recorded motion. All need its file, which replaces what computes one.
void add_recording_properties(ordered_json& motion) {
  motion["properties"].update(key_properties(recording_keys()));
  ordered_json needed = ordered_json::object();
  for (const Key& key : recording_keys()) {
    if (key.name != recording_file_key) needed[key.name] = {recording_file_key};
  }
  motion["dependentRequired"] = std::move(needed);
  ordered_json rules = ordered_json::array();
  for (const char* key : keys_of_computed_motions) {
    rules.push_back({{"not", required({recording_file_key, key})}});
  }
  motion["allOf"] = std::move(rules);
}

/// Adds the tables that give a body.
void add_body_properties(ordered_json& properties) {
  properties["part"] = array_of_tables("#/$defs/part", limits::max_parts);
  properties["body"] = {{"$ref", "#/$defs/body"}};
}

ordered_json shot_schema() {
  ordered_json properties = key_properties(shot_keys());
  properties["speed"] = shot_speed_schema();
  properties["start"] = shot_start_schema();
  add_body_properties(properties);
  for (const char* table : field_tables_of_shots) {
    properties[table] =
        table_schema("Values of this shot; the others are the film's", fields_of_shots(table));
  }
  ordered_json schema = table_schema("A shot of the film", std::move(properties));
  schema.update(required(required_keys(shot_keys())));
  return schema;
}

const std::map<std::string, std::string>& table_descriptions() {
  static const std::map<std::string, std::string> all{
      {"motion", "The initial condition, and how the motion is computed"},
      {"film", "The frames of the video"},
      {"look", "The look of the picture"},
      {"camera", "The camera, which looks at the centre of mass"},
      {"overlay", "The view and its overlays"}};
  return all;
}

}  // namespace

ordered_json scene_schema() {
  ordered_json properties = ordered_json::object();
  add_body_properties(properties);
  for (const Field& field : fields()) {
    ordered_json schema = field_schema_with_default(field);
    if (field.table.empty()) {
      properties[field.key] = std::move(schema);
      continue;
    }
    if (!properties.contains(field.table)) {
      properties[field.table] =
          table_schema(table_descriptions().at(field.table), ordered_json::object());
    }
    properties[field.table]["properties"][field.key] = std::move(schema);
  }
  add_recording_properties(properties["motion"]);
  properties["shot"] = array_of_tables("#/$defs/shot", limits::max_shots);
  ordered_json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                      {"title", "Scene file of twrench"}};
  schema.update(
      table_schema("A rigid body, its motion and its film. Lengths are in cm, masses in "
                   "g, times in s and angles in rad.",
                   std::move(properties)));
  schema["anyOf"] = ordered_json::array({required({"part"}), required({"body"})});
  schema["$defs"] = {{"part", part_schema()}, {"body", body_schema()}, {"shot", shot_schema()}};
  return schema;
}

}  // namespace twrench::scene

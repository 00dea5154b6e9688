#include "scene/scene_values.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/words.h"
#include "scene/dimensions.h"
#include "scene/fields.h"
#include "scene/interior.h"
#include "scene/limits.h"
#include "scene/natural_times.h"

namespace twrench::scene {
namespace {

using nlohmann::ordered_json;

bool is_array_of(const ordered_json& value, std::size_t count, bool (ordered_json::*is)() const) {
  return value.is_array() && (count == 0 || value.size() == count) &&
         std::ranges::all_of(value, [is](const ordered_json& entry) { return (entry.*is)(); });
}

/// Throws unless the value has that form.
void require_form(ValueForm::Kind kind, const ordered_json& value, const std::string& what) {
  const auto require = [&](bool has_form, const char* form) {
    if (!has_form) throw InvalidArgument(what, fmt::format("must be {}", form));
  };
  switch (kind) {
    case ValueForm::Kind::number:
    case ValueForm::Kind::integer:
      return require(value.is_number(), "a number");
    case ValueForm::Kind::rate:
      return require(value.is_number() || value.is_string(), "a number or a fraction");
    case ValueForm::Kind::vector:
      return require(is_array_of(value, 3, &ordered_json::is_number), "an array of 3 numbers");
    case ValueForm::Kind::quaternion:
      return require(is_array_of(value, 4, &ordered_json::is_number), "an array of 4 numbers");
    case ValueForm::Kind::size:
      return require(is_array_of(value, 2, &ordered_json::is_number), "an array of 2 numbers");
    case ValueForm::Kind::text:
      return require(value.is_string(), "a string");
    case ValueForm::Kind::texts:
      return require(is_array_of(value, 0, &ordered_json::is_string), "an array of strings");
    case ValueForm::Kind::vectors:
      return require(value.is_array() && std::ranges::all_of(value,
                                                             [](const ordered_json& entry) {
                                                               return is_array_of(
                                                                   entry, 3,
                                                                   &ordered_json::is_number);
                                                             }),
                     "an array of arrays of 3 numbers");
    case ValueForm::Kind::flag:
      return require(value.is_boolean(), "true or false");
  }
}

/// Throws unless a scene file could contain the part.
void require_allowed(const body::Part& part, const std::string& what) {
  check_dimensions(part.shape, [&](const std::string& key) { return what + "." + key; });
  limits::check(limits::density, what + ".density", part.density);
  limits::check(limits::coordinate, what + ".position", part.position);
}

/// Throws unless the body and the motion of the scene and of each shot suit each other.
void require_interiors(const Scene& scene) {
  check_interior(scene, [](const std::string& key) { return key; });
  for (const Shot& shot : scene.shots) require_interiors(shot.scene);
}

}  // namespace

void require_without_shots(const Scene& scene, const std::string& key) {
  if (scene.shots.empty()) return;
  throw InvalidArgument(key, "each shot of " + scene.name + " has its own",
                        "change the shots in the scene file");
}

void set_value(Scene& scene, const std::string& key, const ordered_json& value) {
  const auto field = std::ranges::find(fields(), key, &Field::key);
  if (field == fields().end()) {
    std::vector<std::string> keys;
    std::ranges::transform(fields(), std::back_inserter(keys), &Field::key);
    throw unknown_name("scene", key, keys);
  }
  require_form(field->form.kind, value, key);
  if (key == "omega" || key == "duration" || key == "speed") require_without_shots(scene, key);
  Scene changed = scene;
  field->set(changed, value, key);
  for (Shot& shot : changed.shots) field->set(shot.scene, value, key);
  require_interiors(changed);
  set_natural_times(changed);
  scene = std::move(changed);
}

void set_body(Scene& scene, Body body) {
  require_without_shots(scene, "body");
  if (body.parts.size() > limits::max_parts) {
    throw InvalidArgument("body", fmt::format("has {} parts, but at most {} are allowed",
                                              body.parts.size(), limits::max_parts));
  }
  for (std::size_t i = 0; i < body.parts.size(); ++i) {
    require_allowed(body.parts[i], fmt::format("part[{}]", i));
  }
  if (body.inertia) {
    body.inertia = limits::check_inertia("inertia", *body.inertia);
  } else {
    limits::check_moments("body", mass_properties(body).moments);
  }
  Scene changed = scene;
  replace_body(changed, std::move(body));
  require_interiors(changed);
  set_natural_times(changed);
  scene = std::move(changed);
}

}  // namespace twrench::scene

#include "scene/scene_json.h"

#include <twrench/math/so3.h>

#include "scene/fields.h"

namespace twrench::scene {
namespace {

using nlohmann::ordered_json;

ordered_json numbers(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

ordered_json shape_json(const body::Cylinder& c) {
  return {{"shape", "cylinder"}, {"radius", c.radius}, {"length", c.length}};
}

ordered_json shape_json(const body::Box& b) {
  return {{"shape", "box"}, {"size", numbers(b.size)}};
}

ordered_json shape_json(const body::Ellipsoid& e) {
  return {{"shape", "ellipsoid"}, {"radii", numbers(e.radii)}};
}

ordered_json shape_json(const auto&) { return ordered_json::object(); }

ordered_json part_json(const body::Part& part, const std::string& name) {
  ordered_json json = std::visit([](const auto& shape) { return shape_json(shape); }, part.shape);
  if (!name.empty()) json["name"] = name;
  json["density"] = part.density;
  json["position"] = numbers(part.position);
  json["rotation"] = numbers(so3::log(part.body_from_part));
  return json;
}

ordered_json parts_json(const Body& body) {
  ordered_json json = ordered_json::array();
  for (std::size_t i = 0; i < body.parts.size(); ++i) {
    json.push_back(part_json(body.parts[i], description(body, i).name));
  }
  return json;
}

/// Returns the object under that name. It is created as one: a null value that the library turns
/// into an object when it is used as one does not survive a lack of memory.
ordered_json& table_in(ordered_json& json, const std::string& name) {
  return name.empty() ? json : *json.emplace(name, ordered_json::object()).first;
}

ordered_json body_json(const Body& body) {
  ordered_json json = ordered_json::object();
  if (!body.parts.empty()) json["part"] = parts_json(body);
  if (body.moments) json["body"] = {{"moments", numbers(*body.moments)}};
  return json;
}

ordered_json speed_json(const SpeedCurve& speed) {
  ordered_json json = ordered_json::array();
  for (const auto& [time, value] : speed.points) json.push_back({time, value});
  return json;
}

/// The shot's own values, and those of its fields and its body that differ from the film's.
ordered_json shot_json(const Shot& shot, const Scene& film) {
  ordered_json json{{"length", *shot.scene.length},
                    {"caption", shot.scene.caption.value_or("")},
                    {"fade", shot.fade},
                    {"move", shot.move},
                    {"start", shot.start},
                    {"speed", speed_json(shot.speed)}};
  for (const Field& field : fields()) {
    ordered_json value = field.get(shot.scene);
    if (field.table == "film" || value == field.get(film)) continue;
    table_in(json, field.table)[field.key] = std::move(value);
  }
  const ordered_json body = body_json(shot.scene.body);
  if (body != body_json(film.body)) json.update(body);
  return json;
}

}  // namespace

ordered_json scene_json(const Scene& scene) {
  ordered_json json = ordered_json::object();
  for (const Field& field : fields()) {
    ordered_json value = field.get(scene);
    if (value.is_null()) continue;
    table_in(json, field.table)[field.key] = std::move(value);
  }
  json.update(body_json(scene.body));
  if (!scene.shots.empty()) {
    ordered_json shots = ordered_json::array();
    for (const Shot& shot : scene.shots) shots.push_back(shot_json(shot, scene));
    json["shot"] = std::move(shots);
  }
  // JSON is UTF-8: invalid bytes in a title or a font's path are replaced here as they are in a
  // file.
  return ordered_json::parse(json.dump(-1, ' ', false, ordered_json::error_handler_t::replace));
}

}  // namespace twrench::scene

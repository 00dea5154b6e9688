#include "scene/scene_json.h"

#include <twrench/math/so3.h>

#include <nlohmann/json.hpp>

#include "base/enumeration.h"
#include "body/dimensions.h"
#include "scene/fields.h"
#include "scene/recording_file.h"
#include "scene/shown_recording.h"
#include "system/bytes.h"

namespace twrench::scene {
namespace {

using nlohmann::ordered_json;

ordered_json numbers(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

void add_dimensions(ordered_json& json, body::Shape shape) {
  for (const body::Dimension& dimension : body::dimensions(shape)) {
    const std::span<double> values = dimension.values;
    json[dimension.key] = values.size() == 1
                              ? ordered_json(values[0])
                              : ordered_json(std::vector(values.begin(), values.end()));
  }
}

/// SHA-256 of a mesh that was not read from a file.
std::string digest_of(const body::TriangleMesh& mesh) {
  std::vector<std::uint8_t> bytes;
  const auto add = [&](const auto& values) {
    const auto* first = reinterpret_cast<const std::uint8_t*>(values.data());
    bytes.insert(bytes.end(), first, first + values.size() * sizeof(values[0]));
  };
  add(mesh.vertices);
  add(mesh.triangles);
  add(mesh.colors);
  return system::sha256_hex(bytes);
}

/// The digest reveals a change of the file.
void add_mesh(ordered_json& json, const body::Mesh& mesh, const PartDescription& description) {
  if (const auto& source = description.mesh) {
    json["file"] = source->file;
    if (source->scale) json["scale"] = *source->scale;
    json["weld"] = source->weld;
  }
  json["crease"] = description.look.crease_angle;
  json["sha256"] = description.mesh ? description.mesh->sha256 : digest_of(*mesh.surface);
}

void add_look(ordered_json& json, const PartLook& look) {
  if (look.color) json["color"] = to_string(*look.color);
  if (look.metallic) json["metallic"] = *look.metallic;
  if (look.roughness) json["roughness"] = *look.roughness;
}

ordered_json part_json(const body::Part& part, const PartDescription& description) {
  ordered_json json{{"shape", body::shape_name(part.shape)}};
  add_dimensions(json, part.shape);
  if (const auto* mesh = std::get_if<body::Mesh>(&part.shape)) add_mesh(json, *mesh, description);
  if (!description.name.empty()) json["name"] = description.name;
  json["density"] = part.density;
  json["position"] = numbers(part.position);
  json["rotation"] = numbers(so3::log(part.body_from_part));
  add_look(json, description.look);
  return json;
}

ordered_json parts_json(const Body& body) {
  ordered_json json = ordered_json::array();
  for (std::size_t i = 0; i < body.parts.size(); ++i) {
    json.push_back(part_json(body.parts[i], description(body, i)));
  }
  return json;
}

/// Returns the object with that name. It is created explicitly, because the implicit conversion of
/// a null value to an object is not safe when memory runs out.
ordered_json& table_in(ordered_json& json, const std::string& name) {
  return name.empty() ? json : *json.emplace(name, ordered_json::object()).first;
}

/// The moments if the body's axes are principal, otherwise the rows of the matrix.
ordered_json inertia_json(const Eigen::Matrix3d& inertia) {
  if (inertia.isDiagonal(0.0)) return {{"moments", numbers(inertia.diagonal())}};
  return {{"inertia", {numbers(inertia.row(0)), numbers(inertia.row(1)), numbers(inertia.row(2))}}};
}

ordered_json body_json(const Body& body) {
  ordered_json json = ordered_json::object();
  if (!body.parts.empty()) json["part"] = parts_json(body);
  if (body.inertia) {
    json["body"] = inertia_json(*body.inertia);
    json["body"]["shape"] = enumerator_name(body.drawn_as);
  }
  return json;
}

/// The keys that name the recorded motion, which are in one object, and how it was read.
void add_recording(ordered_json& json, const Motion& motion) {
  ordered_json recording = ordered_json::object();
  if (motion.recording) recording["file"] = motion.recording->file;
  if (motion.recording_file) recording.update(ordered_json::parse(motion.recording_file->keys));
  if (motion.recording) {
    // The digest reveals another recording, or another reading of it.
    recording["sha256"] = motion.recording->sha256;
    recording["drift"] = motion.recording->drift;
  }
  if (!recording.empty()) json["recording"] = std::move(recording);
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
  if (shot.narration.is_given()) json["narration"] = shot.narration.file;
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
  add_recording(json["motion"], scene.motion);
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

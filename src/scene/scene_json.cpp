#include "scene/scene_json.h"

#include "math/so3.h"

namespace twrench {
namespace {

using nlohmann::ordered_json;

ordered_json numbers(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

ordered_json shape_json(const Cylinder& c) {
  return {{"shape", "cylinder"}, {"radius", c.radius}, {"length", c.length}};
}

ordered_json shape_json(const Box& b) { return {{"shape", "box"}, {"size", numbers(b.size)}}; }

ordered_json shape_json(const Ellipsoid& e) {
  return {{"shape", "ellipsoid"}, {"radii", numbers(e.radii)}};
}

ordered_json part_json(const Part& part) {
  ordered_json json = std::visit([](const auto& shape) { return shape_json(shape); }, part.shape);
  json["density"] = part.density;
  json["position"] = numbers(part.position);
  json["rotation"] = numbers(so3::log(part.body_from_part));
  return json;
}

}  // namespace

ordered_json scene_json(const Scene& scene) {
  const auto& [omega, method, control, duration] = scene.motion;
  const Film& film = scene.film;
  const Look& look = scene.look;
  ordered_json json{{"title", scene.title}};
  for (const Part& part : scene.body.parts) json["part"].push_back(part_json(part));
  if (scene.body.moments) json["body"] = {{"moments", numbers(*scene.body.moments)}};
  json["motion"] = {{"omega", numbers(omega)},
                    {"method", method},
                    {"step", control.step},
                    {"tolerance", control.tolerance},
                    {"duration", duration}};
  json["film"] = {{"size", {film.width, film.height}}, {"fps", film.fps}, {"speed", film.speed}};
  json["look"] = {{"samples", look.samples},
                  {"bare", look.bare},
                  {"color", to_string(look.color)},
                  {"metallic", look.metallic},
                  {"roughness", look.roughness},
                  {"field_of_view", look.field_of_view},
                  {"camera", numbers(look.camera)}};
  if (look.transparent) json["look"]["background"] = "transparent";
  if (look.background) json["look"]["background"] = to_string(*look.background);
  return json;
}

}  // namespace twrench

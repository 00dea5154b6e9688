#include "scene/scene_json.h"

#include "math/so3.h"
#include "scene/names.h"

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

/// Omits what the theme decides.
ordered_json look_json(const Look& look) {
  ordered_json json{
      {"theme", name_of(look.theme)}, {"samples", look.samples}, {"motion_blur", look.motion_blur}};
  if (look.transparent) json["background"] = "transparent";
  if (look.background) json["background"] = to_string(*look.background);
  if (look.color) json["color"] = to_string(*look.color);
  if (look.metallic) json["metallic"] = *look.metallic;
  if (look.roughness) json["roughness"] = *look.roughness;
  return json;
}

ordered_json overlay_json(const Overlay& overlay) {
  ordered_json json{{"view", name_of(overlay.view)}, {"show", ordered_json::array()}};
  for (const Feature feature : overlay.show) json["show"].push_back(name_of(feature));
  if (!overlay.compare.empty()) json["compare"] = overlay.compare;
  if (overlay.trail_point) json["trail_point"] = numbers(*overlay.trail_point);
  if (overlay.trail_length) json["trail_length"] = *overlay.trail_length;
  json["font"] = overlay.font;
  return json;
}

}  // namespace

ordered_json scene_json(const Scene& scene) {
  const auto& [omega, method, control, duration] = scene.motion;
  const Film& film = scene.film;
  ordered_json json{{"title", scene.title}};
  for (const Part& part : scene.body.parts) json["part"].push_back(part_json(part));
  if (scene.body.moments) json["body"] = {{"moments", numbers(*scene.body.moments)}};
  json["motion"] = {{"omega", numbers(omega)},
                    {"method", method},
                    {"step", control.step},
                    {"tolerance", control.tolerance},
                    {"duration", duration}};
  json["film"] = {{"size", {film.width, film.height}}, {"fps", film.fps}, {"speed", film.speed}};
  json["look"] = look_json(scene.look);
  json["camera"] = {{"azimuth", scene.camera.azimuth},
                    {"elevation", scene.camera.elevation},
                    {"distance", scene.camera.distance},
                    {"orbit", scene.camera.orbit},
                    {"field_of_view", scene.camera.field_of_view}};
  json["overlay"] = overlay_json(scene.overlay);
  // JSON is UTF-8: invalid bytes in a title or a font's path are replaced here as they are in a
  // file.
  return ordered_json::parse(json.dump(-1, ' ', false, ordered_json::error_handler_t::replace));
}

}  // namespace twrench

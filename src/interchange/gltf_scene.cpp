#include "interchange/gltf_scene.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "interchange/surface.h"
#include "interchange/track.h"
#include "math/rotation_between.h"
#include "picture/body/bounding_radius.h"
#include "picture/body/gap_closing.h"
#include "picture/compose/camera_path.h"
#include "picture/look/emphasis.h"
#include "picture/look/material.h"
#include "picture/overlay/body_overlay.h"
#include "scene/reference_frame.h"

namespace twrench::interchange {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using Json = Gltf::Json;

std::vector<double> numbers_of(const Vector3d& v) { return {v.begin(), v.end()}; }

std::vector<double> numbers_of(const Quaterniond& q) { return {q.x(), q.y(), q.z(), q.w()}; }

/// Returns linear R, G, B and A.
std::vector<double> linear(const Color& color, double factor = 1) {
  const auto channel = [&](int value) { return picture::linear_from_srgb(factor * value); };
  return {channel(color.red), channel(color.green), channel(color.blue)};
}

/// The scene with all arrows of the document, so that they are in the view of its camera.
scene::Scene with_all_arrows(scene::Scene scene) {
  using enum scene::Feature;
  scene.overlay.show.insert({axes, momentum, omega});
  return scene;
}

/// Assembles the document.
class SceneWriter {
 public:
  SceneWriter(const scene::Scene& scene, const AnimationOptions& options,
              const std::string& generator)
      : scene_(scene),
        options_(options),
        gltf_(generator),
        style_(picture::style_of(scene.look.theme)),
        colors_(picture::emphasised(style_.overlay, scene.overlay)),
        body_(scene::free_body(scene)),
        played_(body_, options.speed, scene.motion.duration / options.speed,
                scene.motion.control.stop, scene.motion.recording),
        radius_(picture::bounding_radius(scene::visible_parts(scene.body))),
        overlay_(with_all_arrows(scene), body_, radius_) {}

  Gltf finish() && {
    const std::size_t camera = add_camera();
    if (scene_.camera.frame != scene::Frame::body) nodes_.push_back(camera);
    add_body(camera);
    const bool has_momentum = !body_.momentum().isZero(0);
    if (scene_.motion.recording) {
      // Whose omega may change abruptly, so that no keys bound the error of an arrow.
      if (has_momentum && scene_.overlay.shows(scene::Feature::momentum)) add_momentum();
    } else if (has_momentum) {
      add_momentum();
      // A body whose wheel alone turns is at rest, although it has momentum.
      if (!body_.initial_rate().isZero(0)) add_omega();
    }
    gltf_.add("animations", animation_);
    gltf_.add("scenes", {{"name", scene_.name}, {"nodes", nodes_}});
    return std::move(gltf_);
  }

 private:
  void add_body(std::size_t camera);
  std::size_t material_of(std::size_t part, bool is_colored);
  std::size_t add_arrow_mesh(const std::string& name, double length, double shaft,
                             const Color& color);
  std::size_t add_mesh(const std::string& name, const Surface& surface, std::size_t material);
  void add_momentum();
  void add_omega();
  std::size_t add_camera();
  std::size_t add_turntable(const char* name, std::size_t child, const Vector3d& omega);
  std::vector<Vector3d> extent_in_frame() const;
  void add_channel(std::size_t node, const char* path, std::size_t times, std::size_t keys);
  double end() const { return scene_.motion.duration / options_.speed; }

  const scene::Scene& scene_;
  AnimationOptions options_;
  Gltf gltf_;
  const picture::ThemeStyle& style_;
  picture::OverlayColors colors_;
  motion::FreeBody body_;
  PlayedMotion played_;
  double radius_;  ///< Bounding radius of the body in cm.
  picture::BodyOverlay overlay_;
  std::vector<std::size_t> nodes_;                            ///< The roots.
  std::vector<std::pair<Json, std::size_t>> part_materials_;  ///< With their indices.
  Json animation_{
      {"name", "free rotation"}, {"samplers", Json::array()}, {"channels", Json::array()}};
};

std::size_t SceneWriter::add_mesh(const std::string& name, const Surface& surface,
                                  std::size_t material) {
  Json attributes{{"POSITION", gltf_.add_floats(surface.positions, 3, Gltf::Use::vertices)},
                  {"NORMAL", gltf_.add_floats(surface.normals, 3, Gltf::Use::vertices)}};
  if (!surface.colors.empty()) {
    attributes["COLOR_0"] = gltf_.add_floats(surface.colors, 3, Gltf::Use::vertices);
  }
  const Json primitive{{"attributes", attributes},
                       {"indices", gltf_.add_indices(surface.indices)},
                       {"material", material}};
  return gltf_.add("meshes", {{"name", name}, {"primitives", Json::array({primitive})}});
}

/// Returns the material of a part; parts that look the same share it. The colours of vertices are
/// multiplied by that of their material, which is then white.
std::size_t SceneWriter::material_of(std::size_t part, bool is_colored) {
  const scene::Look& look = scene_.look;
  const scene::PartLook own = scene::description(scene_.body, part).look;
  std::vector<double> color{1, 1, 1};
  if (!is_colored) color = linear(own.color.value_or(look.color.value_or(style_.metal)));
  color.push_back(1);
  const auto [metallic, roughness] = picture::finish(look, own, is_colored);
  const Json surface{
      {"baseColorFactor", color}, {"metallicFactor", metallic}, {"roughnessFactor", roughness}};
  const auto found =
      std::ranges::find(part_materials_, surface, &std::pair<Json, std::size_t>::first);
  if (found != part_materials_.end()) return found->second;
  const std::string name = part_materials_.empty() ? "body" : fmt::format("body {}", part + 1);
  const std::size_t index =
      gltf_.add("materials", {{"name", name}, {"pbrMetallicRoughness", surface}});
  part_materials_.emplace_back(surface, index);
  return index;
}

/// An arrow keeps most of its colour in the shade, as in the film, and without any light.
std::size_t SceneWriter::add_arrow_mesh(const std::string& name, double length, double shaft,
                                        const Color& color) {
  constexpr double in_shade = 0.72;  // as in DrawList
  const std::vector<double> dark = linear(color, in_shade), full = linear(color);
  std::vector<double> base;
  for (std::size_t i = 0; i < 3; ++i) base.push_back(full[i] - dark[i]);
  base.push_back(1);
  const std::size_t material = gltf_.add(
      "materials", {{"name", name},
                    {"pbrMetallicRoughness",
                     {{"baseColorFactor", base}, {"metallicFactor", 0}, {"roughnessFactor", 0.6}}},
                    {"emissiveFactor", dark}});
  return add_mesh(name, arrow_surface(length, shaft), material);
}

void SceneWriter::add_channel(std::size_t node, const char* path, std::size_t times,
                              std::size_t keys) {
  Json& samplers = animation_["samplers"];
  samplers.push_back({{"input", times}, {"output", keys}, {"interpolation", "LINEAR"}});
  animation_["channels"].push_back(
      {{"sampler", samplers.size() - 1}, {"target", {{"node", node}, {"path", path}}}});
}

/// Adds the body with its children, which turn with it: the parts, the axes, and the camera if that
/// is in the frame of the body.
void SceneWriter::add_body(std::size_t camera) {
  constexpr double finest = 3e-4;  // of the radius: a seventh of a pixel in a picture 1080 high
  const std::vector<body::Part> parts = picture::close_gaps(scene::visible_parts(scene_.body));
  std::vector<std::size_t> children;
  if (scene_.camera.frame == scene::Frame::body) children.push_back(camera);
  for (const scene::PartGroup& group : scene::part_groups(scene_.body)) {
    for (const std::size_t part : group.parts) {
      const double crease = scene::description(scene_.body, part).look.crease_angle;
      const Surface surface = part_surface(parts[part], finest * radius_, crease);
      const std::size_t material = material_of(part, !surface.colors.empty());
      const std::size_t mesh = add_mesh(group.name, surface, material);
      children.push_back(gltf_.add("nodes", {{"name", group.name}, {"mesh", mesh}}));
    }
  }
  static constexpr std::array names{"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t mesh = add_arrow_mesh(names[i], overlay_.axis_arrow_length(),
                                            overlay_.axis_shaft(), colors_.axis[i]);
    const Quaterniond turn = turn_z_to(Vector3d::Unit(static_cast<Eigen::Index>(i)));
    children.push_back(
        gltf_.add("nodes", {{"name", names[i]}, {"mesh", mesh}, {"rotation", numbers_of(turn)}}));
  }
  const std::size_t node = gltf_.add("nodes", {{"name", "body"}, {"children", children}});
  nodes_.push_back(node);

  const Track track = attitude_track(played_, end(), options_.max_angle);
  add_channel(node, "rotation", gltf_.add_floats(track.times, 1, Gltf::Use::keys),
              gltf_.add_floats(track.rotations, 4, Gltf::Use::keys));
}

void SceneWriter::add_momentum() {
  const Vector3d tip = overlay_.momentum_tip();
  const std::size_t mesh =
      add_arrow_mesh("L", tip.norm(), overlay_.momentum_shaft(), colors_.momentum);
  nodes_.push_back(gltf_.add(
      "nodes", {{"name", "L"}, {"mesh", mesh}, {"rotation", numbers_of(turn_z_to(tip))}}));
}

void SceneWriter::add_omega() {
  const double length = overlay_.omega_tip(played_.at(0)).norm();
  const std::size_t mesh = add_arrow_mesh("omega", length, overlay_.omega_shaft(), colors_.omega);
  const std::size_t node = gltf_.add("nodes", {{"name", "omega"}, {"mesh", mesh}});
  nodes_.push_back(node);
  const Track track = omega_track(played_, end(), options_.max_angle);
  std::vector<float> scales;
  for (const float factor : track.lengths) scales.insert(scales.end(), 3, factor);
  const std::size_t times = gltf_.add_floats(track.times, 1, Gltf::Use::keys);
  add_channel(node, "rotation", times, gltf_.add_floats(track.rotations, 4, Gltf::Use::keys));
  add_channel(node, "scale", times, gltf_.add_floats(scales, 3, Gltf::Use::keys));
}

/// Adds a node that turns steadily and carries another; `omega` in rad/s of the animation.
std::size_t SceneWriter::add_turntable(const char* name, std::size_t child, const Vector3d& omega) {
  if (omega.isZero(0)) return child;
  const std::size_t node = gltf_.add("nodes", {{"name", name}, {"children", Json::array({child})}});
  const Track track = steady_track(omega, end(), options_.max_angle);
  add_channel(node, "rotation", gltf_.add_floats(track.times, 1, Gltf::Use::keys),
              gltf_.add_floats(track.rotations, 4, Gltf::Use::keys));
  return node;
}

/// Returns the positions of the arrows' tips over time in the frame of the camera, in cm.
std::vector<Vector3d> SceneWriter::extent_in_frame() const {
  constexpr int samples = 500;
  const scene::Frame frame = scene_.camera.frame;
  std::vector<Vector3d> points;
  for (int i = 0; i <= (frame == scene::Frame::space ? 0 : samples); ++i) {
    const motion::Sample sample = played_.at(end() * i / samples);
    const motion::RotatingFrame now = scene::reference_frame(frame, body_, sample);
    for (const Vector3d& p : overlay_.extent()) points.emplace_back(now.attitude.transpose() * p);
  }
  return points;
}

/// A camera of glTF looks along the middle of its picture. If the film's camera does not, that of
/// glTF is turned to look at the middle of the film's picture.
std::size_t SceneWriter::add_camera() {
  const double aspect = static_cast<double>(scene_.film.width) / scene_.film.height;
  const picture::Framing framing =
      picture::framing_along(scene_, aspect, overlay_.bounding_radius(), extent_in_frame());
  const picture::Camera camera = picture::frame_sphere(framing);
  const Eigen::Matrix4d& p = camera.projection;
  const Vector3d ahead(p(0, 2) / p(0, 0), p(1, 2) / p(1, 1), -1);
  const double height = std::atan((1 + p(1, 2)) / p(1, 1)) + std::atan((1 - p(1, 2)) / p(1, 1));
  const Quaterniond space_from_camera(camera.camera_from_space().transpose());
  const Quaterniond turn = space_from_camera * so3::rotation_between(-Vector3d::UnitZ(), ahead);
  const Vector3d eye = metres_per_cm * camera.distance * (space_from_camera * Vector3d::UnitZ());
  const std::size_t index =
      gltf_.add("cameras", {{"name", "camera"},
                            {"type", "perspective"},
                            {"perspective",
                             {{"aspectRatio", aspect},
                              {"yfov", height},
                              {"znear", metres_per_cm * 0.05 * camera.distance},
                              {"zfar", metres_per_cm * 20 * camera.distance}}}});
  const std::size_t node = gltf_.add("nodes", {{"name", "camera"},
                                               {"camera", index},
                                               {"translation", numbers_of(eye)},
                                               {"rotation", numbers_of(turn)}});
  const double orbit = scene_.camera.orbit * options_.speed / scene_.film.speed;
  const std::size_t carried = add_turntable("orbit", node, orbit * Vector3d::UnitY());
  if (scene_.camera.frame != scene::Frame::rotating) return carried;
  return add_turntable("frame", carried, options_.speed * motion::steady_frame(body_, 0).omega);
}

}  // namespace

Gltf gltf_scene(const scene::Scene& scene, const AnimationOptions& options,
                const std::string& generator) {
  return SceneWriter(scene, options, generator).finish();
}

}  // namespace twrench::interchange

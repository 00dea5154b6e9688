#include "app/scene_options.h"

#include <fmt/format.h>

#include "app/arguments.h"
#include "app/message.h"
#include "app/progress.h"
#include "base/file.h"

namespace twrench {
namespace {

constexpr int most_scenes = 16;

/// A moment is at most the sum of the other two: Ixx + Iyy - Izz is twice the integral of z^2 dm.
void warn_of_unreal_moments(const Scene& scene, bool as_json) {
  if (!scene.body.moments) return;
  const Eigen::Vector3d& moments = *scene.body.moments;
  constexpr double round_off = 1e-12;
  if (2.0 * moments.maxCoeff() <= moments.sum() * (1.0 + round_off)) return;
  warn(fmt::format("{}: moments {}, {} and {}: no real body has them; one exceeds the sum of the "
                   "other two",
                   scene.name, moments[0], moments[1], moments[2]),
       as_json);
}

std::string format_vector(const Eigen::Vector3d& v) {
  return fmt::format("{},{},{}", v.x(), v.y(), v.z());
}

}  // namespace

SceneOptions::SceneOptions(CLI::App& command, Count count) : command_(command) {
  command.add_option("SCENE", names_, ".toml file or built-in scene (see twrench scenes)")
      ->expected(1, count == Count::one ? 1 : most_scenes)
      ->default_str("dzhanibekov");
}

CLI::Option* SceneOptions::add(const std::string& name, const std::string& value,
                               const std::string& help, Override apply) {
  const auto remember = [this, apply = std::move(apply)](const std::string& text) {
    overrides_.emplace_back([=](Scene& scene) { apply(scene, text); });
  };
  return command_.add_option_function<std::string>(name, remember, help)->type_name(value);
}

void SceneOptions::add_number(const std::string& name, const std::string& value,
                              const std::string& help, const limits::Limit& limit,
                              std::function<double&(Scene&)> target) {
  Scene defaults;
  const std::string otherwise = fmt::format("{}", target(defaults));
  add(name, value, help, [=, target = std::move(target)](Scene& scene, const std::string& text) {
    target(scene) = limits::check(limit, name, parse_number(text, name));
  })->default_str(otherwise);
}

void SceneOptions::add_flag(const std::string& name, const std::string& help,
                            std::function<void(Scene&)> apply) {
  command_.add_flag_callback(
      name, [this, apply = std::move(apply)] { overrides_.push_back(apply); }, help);
}

void SceneOptions::add_inertia_option() {
  add("--inertia", "A,B,C", "replace the body by its principal moments of inertia, g cm^2",
      [](Scene& scene, const std::string& text) {
        scene.body.parts.clear();
        scene.body.moments = limits::check_moments(
            "--inertia",
            limits::check(limits::moment, "--inertia", parse_vector(text, "--inertia")));
      });
}

void SceneOptions::add_motion_options() {
  add("--omega", "X,Y,Z", "initial angular velocity in body axes, rad/s",
      [](Scene& scene, const std::string& text) {
        scene.motion.omega = limits::check_omega("--omega", parse_vector(text, "--omega"));
      })
      ->default_str(format_vector(Scene().motion.omega));
  add_inertia_option();
  add("--method", "NAME", "integration method (see twrench methods)",
      [](Scene& scene, const std::string& text) {
        scene.motion.method = find_method(text, "--method").name;
      })
      ->default_str(Scene().motion.method);
  add_number("--step", "H", "step size, s; initial step size of adaptive methods", limits::step,
             [](Scene& s) -> double& { return s.motion.control.step; });
  add_number("--tolerance", "T", "error tolerance per step of adaptive methods", limits::tolerance,
             [](Scene& s) -> double& { return s.motion.control.tolerance; });
  add_number("--duration", "S", "duration of the motion, s", limits::duration,
             [](Scene& s) -> double& { return s.motion.duration; });
  add_number("--fps", "N", "frames (and output samples) per second", limits::fps,
             [](Scene& s) -> double& { return s.film.fps; });
  add_number("--speed", "F", "seconds of motion per second of video", limits::speed,
             [](Scene& s) -> double& { return s.film.speed; });
}

void SceneOptions::require_not_input(const std::filesystem::path& output) const {
  for (const std::string& name : names_) twrench::require_not_input(output, name);
  for (const Scene& scene : load()) twrench::require_not_input(output, scene.overlay.font);
}

std::vector<Scene> SceneOptions::load() const {
  std::vector<Scene> scenes;
  for (const std::string& name : names_) {
    Scene scene = load_scene(name);
    for (const auto& override_value : overrides_) override_value(scene);
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

std::vector<Scene> SceneOptions::scenes() const {
  std::vector<Scene> scenes = load();
  for (const Scene& scene : scenes) warn_of_unreal_moments(scene, Progress::is_json(command_));
  return scenes;
}

}  // namespace twrench

#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "scene/limits.h"
#include "scene/scene.h"

namespace twrench {

/// For the footer of a command with options of the scene.
inline constexpr const char* about_defaults =
    "Options override the scene; the defaults apply to what neither sets.\n";

/// The SCENE argument, or several, and the options that override its values. Lives as long as the
/// command.
class SceneOptions {
 public:
  using Override = std::function<void(Scene&, const std::string& text)>;

  /// How many scenes the command takes.
  enum class Count { one, several };

  explicit SceneOptions(CLI::App& command, Count count = Count::one);

  /// --omega, --inertia, --method, --step, --tolerance, --duration, --fps, --speed.
  void add_motion_options();

  /// An option whose text changes the scene. `apply` throws UsageError about the option's name.
  /// The default_str of what is returned is for the help: what a scene has that does not say.
  CLI::Option* add(const std::string& name, const std::string& value, const std::string& help,
                   Override apply);
  /// An option that is a number within `limit`, to be written to where `target` points.
  void add_number(const std::string& name, const std::string& value, const std::string& help,
                  const limits::Limit& limit, std::function<double&(Scene&)> target);

  /// An option without a value that changes the scene.
  void add_flag(const std::string& name, const std::string& help,
                std::function<void(Scene&)> apply);

  /// --inertia alone.
  void add_inertia_option();

  /// The scene with everything overridden. Throws as load_scene, and UsageError. Warns on standard
  /// error of moments that no real body has.
  Scene scene() const { return scenes().front(); }

  /// Throws UsageError where `output` is a scene file that was named, or a font of such a scene.
  void require_not_input(const std::filesystem::path& output) const;

  /// All of them, each as scene() is.
  std::vector<Scene> scenes() const;

 private:
  /// The scenes, without a word.
  std::vector<Scene> load() const;

  CLI::App& command_;
  std::vector<std::string> names_{"dzhanibekov"};
  std::vector<std::function<void(Scene&)>> overrides_;  ///< in the order of the options' definition
};

}  // namespace twrench

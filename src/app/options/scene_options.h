#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/options/command_line.h"
#include "app/options/mesh_options.h"
#include "app/options/recording_options.h"
#include "app/options/robot_options.h"
#include "scene/fields.h"
#include "scene/scene.h"
#include "system/output.h"

namespace twrench::app {

/// Footer for the help of commands with scene options.
inline constexpr const char* about_defaults =
    "Options override the scene; the defaults apply to what neither sets.\n";

/// The placeholder of --inertia in the help, and the description of its value.
inline constexpr const char* inertia_placeholder = "A,B,C[,D,E,F]";
inline constexpr const char* inertia_help =
    "principal moments of inertia about the body's axes, or the matrix entries "
    "Ixx,Iyy,Izz,Ixy,Ixz,Iyz as in MuJoCo's fullinertia (Ixy is minus the integral of x y dm)";

/// Warns on standard error about an inertia matrix in g cm^2 that no real body has.
void warn_of_unreal_moments(const std::string& of, const Eigen::Matrix3d& inertia,
                            bool as_json = false);

/// Returns the name of the option that sets a field, such as "--trail-point".
std::string option_of(const scene::Field& field);

/// Returns the help of a field, which names the command that lists its values if there is one.
std::string help_of(const scene::Field& field);

/// The SCENE argument (one or several), the options of a mesh, and the options that override values
/// of the scene. Must live as long as the command.
class SceneOptions {
 public:
  /// How many scenes the command accepts.
  enum class Count { one, several };

  /// `without` are the scenes to use if none is given.
  explicit SceneOptions(CLI::App& command, Count count = Count::one,
                        std::vector<std::string> without = {"dzhanibekov"});

  /// Adds --omega, --inertia, --method, --step, --tolerance, --duration, --fps and --speed.
  void add_motion_options();

  /// Adds the options for the shape, the colours and the material, the camera and the size of the
  /// picture.
  void add_look_options();

  /// Adds an option for each other field of a scene, and --language, --shape, --bare, --show and
  /// --hide.
  void add_picture_options();

  /// Adds only --language.
  void add_language_option();

  /// Adds only --inertia.
  void add_inertia_option();

  /// Adds --motion and the options that determine how a recorded motion is read.
  void add_recording_options() { recording_.add_to(command_); }

  /// Adds --length, which determines the duration or the speed.
  void add_length_option();

  /// Uses all built-in scenes. Throws InvalidArgument about `option` if SCENE is given.
  void use_builtin_scenes(const std::string& option);

  /// Returns the scene with all overrides applied. Throws as load_scene() does, and
  /// InvalidArgument. Warns on standard error about repairs to a mesh, and about moments that no
  /// real body has.
  scene::Scene scene() const { return scenes().front(); }

  /// Returns the names or files of the scenes as they were given.
  const std::vector<std::string>& sources() const { return names_; }

  /// Returns a scene without overrides. Throws as load_scene() does.
  const scene::Scene& original(std::size_t index) const;

  /// Returns the name of a scene and, if it is a mesh, its options, as words of a command line.
  std::vector<std::string> words(std::size_t index) const;

  /// Returns what to call the scene in a result: its name, or its title if --inertia replaced its
  /// body.
  const std::string& name_of(const scene::Scene& scene) const;

  /// Returns the options for a recorded motion.
  const RecordingOptions& recording_options() const { return recording_; }

  /// Returns the options for SCENE as a mesh.
  const MeshOptions& mesh_options() const { return mesh_; }

  /// Returns the options for SCENE as a robot description.
  const RobotOptions& robot_options() const { return robot_; }

  /// Throws InvalidArgument if an option would override a value of `name`, which is not a scene.
  void require_no_overrides(const std::string& name) const;

  /// Adds the scene files, and all files that the scenes name, to the inputs. Throws
  /// OverwriteError.
  void add_inputs(system::FileList& files) const;

  /// Returns all scenes, each as scene() does.
  std::vector<scene::Scene> scenes() const;

  /// Throws InvalidArgument if the scene has shots and an option sets a value that each shot has
  /// separately.
  void require_drawable(const scene::Scene& scene) const;

 private:
  using Override = std::function<void(scene::Scene&, const std::string& text)>;

  /// Adds an option whose text changes the scene. `apply` throws InvalidArgument about the option's
  /// name. Set the default_str of the result to the default shown in the help.
  CLI::Option* add(OptionGroup group, const std::string& name, const std::string& value,
                   const std::string& help, Override apply);
  /// Adds the option that sets a field, named after its key.
  void add_field(const scene::Field& field);
  /// Adds a flag that changes the overlays.
  void add_flag(const std::string& name, const std::string& help,
                std::function<void(scene::Scene&)> apply);

  /// Adds --shape, the solid that is drawn for a body given by its inertia.
  void add_shape_option();
  /// A scene without and with the overrides.
  struct Loaded {
    scene::Scene original, overridden = {};
    /// The files of a robot, except its description.
    std::vector<std::filesystem::path> robot_files = {};
  };

  /// Loads the scenes without warnings, and only once, because a pipe can be read only once.
  const std::vector<Loaded>& load() const;
  Loaded load(const std::string& name) const;
  /// Applies --length to a scene with all other overrides.
  void set_length(scene::Scene& scene) const;
  /// Throws InvalidArgument about an option or a key of the scene, as check_interior() does.
  void require_interior(const scene::Scene& scene) const;
  /// Whether the user named the body, rather than leaving it to the default scene.
  bool is_body_given() const;

  CLI::App& command_;
  std::vector<std::string> names_;
  MeshOptions mesh_;
  RobotOptions robot_;
  RecordingOptions recording_;
  /// In the order of the options' definition.
  std::vector<std::function<void(scene::Scene&)>> overrides_;
  std::optional<std::string> language_;  ///< Nothing for that of each scene.
  std::optional<std::string> length_;    ///< Nothing for that of the duration and the speed.
  mutable std::vector<Loaded> loaded_;   ///< Set by load().
};

}  // namespace twrench::app

#include "app/options/scene_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>

#include "app/options/arguments.h"
#include "app/options/command_line.h"
#include "app/terminal/message.h"
#include "base/enumeration.h"
#include "scene/fields.h"
#include "scene/interior.h"
#include "scene/languages.h"
#include "scene/limits.h"
#include "scene/link_scene.h"
#include "scene/mesh_scene.h"
#include "scene/natural_times.h"
#include "scene/shown_recording.h"
#include "scene/video_length.h"
#include "system/file.h"

namespace twrench::app {
namespace {

constexpr int most_scenes = 16;

/// The numbers of a vector as a JSON array.
template <typename Vector>
nlohmann::ordered_json array_of(const Vector& v) {
  return std::vector<double>(v.begin(), v.end());
}

/// Converts the text of an option to the form of a field.
nlohmann::ordered_json parse_value(scene::ValueForm::Kind kind, const std::string& text,
                                   const std::string& option) {
  using Kind = scene::ValueForm::Kind;
  switch (kind) {
    case Kind::number:
    case Kind::integer:
      return parse_number(text, option);
    case Kind::rate:
      if (text.find('/') != std::string::npos) return text;
      return parse_number(text, option);
    case Kind::vector:
      return array_of(parse_vector(text, option));
    case Kind::quaternion:
      return array_of(parse_quaternion(text, option));
    case Kind::size:
      return array_of(parse_size(text, option));
    case Kind::text:
      return text;
    case Kind::texts:
      return parse_words(text);
    case Kind::vectors: {
      nlohmann::ordered_json vectors = nlohmann::ordered_json::array();
      for (const auto& v : parse_vectors(text, option)) vectors.push_back(array_of(v));
      return vectors;
    }
    case Kind::flag:
      return text == "true";
  }
  return {};
}

/// The default of a field as help shows it.
std::string default_text(const scene::Field& field) {
  if (!field.otherwise.empty()) return field.otherwise;
  const nlohmann::ordered_json value = field.get(scene::Scene());
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number()) return fmt::format("{}", value.get<double>());
  return fmt::format("{}", fmt::join(value.get<std::vector<double>>(),
                                     field.form.kind == scene::ValueForm::Kind::size ? "x" : ","));
}

OptionGroup group_of(const scene::Field& field) {
  static const std::map<std::string, OptionGroup> groups{
      {"", OptionGroup::overlays},     {"motion", OptionGroup::motion},
      {"film", OptionGroup::film},     {"look", OptionGroup::picture},
      {"camera", OptionGroup::camera}, {"overlay", OptionGroup::overlays}};
  return groups.at(field.table);
}

/// Whether a field changes the motion or when it is sampled, rather than only the picture.
bool determines_motion(const scene::Field& field) {
  return field.table == "motion" || field.key == "fps" || field.key == "speed";
}

}  // namespace

void warn_of_unreal_moments(const std::string& of, const Eigen::Matrix3d& inertia, bool as_json) {
  if (const auto note = scene::unreal_moments_note(of, inertia)) warn(*note, as_json);
}

std::string option_of(const scene::Field& field) {
  std::string name = "--" + field.key;
  std::ranges::replace(name, '_', '-');
  return name;
}

std::string help_of(const scene::Field& field) {
  return field.key == "method" ? field.help + " (see twrench methods)" : field.help;
}

SceneOptions::SceneOptions(CLI::App& command, Count count, std::vector<std::string> without)
    : command_(command), names_(std::move(without)), mesh_(command), robot_(command) {
  command
      .add_option("SCENE", names_,
                  ".toml file, mesh (.obj, .stl, .ply, .gltf, .glb, .dae, .3mf), robot description "
                  "(.urdf, .sdf, .xml) or built-in scene (see twrench scenes)")
      ->expected(1, count == Count::one ? 1 : most_scenes)
      ->default_str(fmt::format("{}", fmt::join(names_, " ")));
}

CLI::Option* SceneOptions::add(OptionGroup group, const std::string& name, const std::string& value,
                               const std::string& help, Override apply) {
  const auto remember = [this, apply = std::move(apply)](const std::string& text) {
    overrides_.emplace_back([=](scene::Scene& scene) { apply(scene, text); });
  };
  return command_.add_option_function<std::string>(name, remember, help)
      ->type_name(value)
      ->group(heading(group));
}

void SceneOptions::add_field(const scene::Field& field) {
  const std::string name = option_of(field);
  add(group_of(field), name, field.placeholder, help_of(field),
      [&field, name](scene::Scene& scene, const std::string& text) {
        field.set(scene, parse_value(field.form.kind, text, name), name);
      })
      ->default_str(default_text(field));
}

void SceneOptions::add_flag(const std::string& name, const std::string& help,
                            std::function<void(scene::Scene&)> apply) {
  command_
      .add_flag_callback(
          name, [this, apply = std::move(apply)] { overrides_.push_back(apply); }, help)
      ->group(heading(OptionGroup::overlays));
}

void SceneOptions::add_inertia_option() {
  add(OptionGroup::body, "--inertia", inertia_placeholder,
      fmt::format("replace the body, its title and its times by {}, g cm^2", inertia_help),
      [](scene::Scene& scene, const std::string& text) {
        scene::Body body;
        body.inertia = parse_inertia(text, "--inertia");
        body.drawn_as = scene.body.drawn_as;
        scene::replace_body(scene, std::move(body));
      });
}

void SceneOptions::add_motion_options() {
  for (const scene::Field& field : scene::fields()) {
    if (determines_motion(field)) add_field(field);
  }
  add_inertia_option();
}

void SceneOptions::add_length_option() {
  command_
      .add_option_function<std::string>(
          "--length", [this](const std::string& text) { length_ = text; },
          "length of the video, s; with --duration it determines the speed, otherwise the duration")
      ->type_name("S")
      ->default_str("duration / speed")
      ->group(heading(OptionGroup::film));
}

void SceneOptions::add_shape_option() {
  add(OptionGroup::body, "--shape", "NAME",
      fmt::format("solid to draw for a body given by its inertia: {}",
                  fmt::join(enumerator_names<scene::Equimomental>(), ", ")),
      [](scene::Scene& scene, const std::string& text) {
        const scene::Equimomental form = find_enumerator<scene::Equimomental>(text, "--shape");
        if (!scene.body.parts.empty()) {
          throw InvalidArgument(
              "--shape",
              "applies only to a body given by its inertia alone, and this body has parts",
              "give its moments by --inertia, or leave --shape out");
        }
        scene.body.drawn_as = form;
      })
      ->default_str("box");
}

void SceneOptions::add_language_option() {
  const auto remember = [this](const std::string& text) {
    language_ = text;
    overrides_.emplace_back(
        [text](scene::Scene& scene) { scene::set_language(scene, text, "--language"); });
  };
  command_
      .add_option_function<std::string>(
          "--language", remember,
          fmt::format("language of the words in the picture, and of a built-in story: {}; with "
                      "another tag of BCP 47, that of the captions beside English words",
                      fmt::join(enumerator_names<scene::Language>(), " or ")))
      ->type_name("TAG")
      ->default_str("the scene's")
      ->group(heading(OptionGroup::overlays));
}

void SceneOptions::add_look_options() {
  add_shape_option();
  static constexpr std::array keys{"size",     "theme",     "material",      "color",
                                   "metallic", "roughness", "azimuth",       "elevation",
                                   "distance", "orbit",     "field_of_view", "frame"};
  for (const scene::Field& field : scene::fields()) {
    if (std::ranges::find(keys, field.key) != keys.end()) add_field(field);
  }
}

void SceneOptions::add_picture_options() {
  add_language_option();
  add_shape_option();
  for (const scene::Field& field : scene::fields()) {
    const bool is_special = field.key == "show" || field.key == "language";
    if (!determines_motion(field) && !is_special) add_field(field);
  }
  // Declared in this order, so that --show adds to --bare.
  add_flag("--bare", "show only the body; --show adds to it",
           [](scene::Scene& scene) { scene.overlay.show.clear(); });
  add(OptionGroup::overlays, "--show", "LIST",
      fmt::format("show also: {}", fmt::join(enumerator_names<scene::Feature>(), ", ")),
      [](scene::Scene& scene, const std::string& text) {
        for (const std::string& word : parse_words(text)) {
          scene.overlay.show.insert(find_enumerator<scene::Feature>(word, "--show"));
        }
      });
  add(OptionGroup::overlays, "--hide", "LIST", "hide items of the same list",
      [](scene::Scene& scene, const std::string& text) {
        for (const std::string& word : parse_words(text)) {
          scene.overlay.show.erase(find_enumerator<scene::Feature>(word, "--hide"));
        }
      });
}

void SceneOptions::require_no_overrides(const std::string& name) const {
  if (overrides_.empty()) return;
  throw InvalidArgument(name, "only the values of a scene can be replaced",
                        "leave the options for those out");
}

void SceneOptions::use_builtin_scenes(const std::string& option) {
  if (command_.count("SCENE") > 0) {
    throw InvalidArgument(option, "takes all built-in scenes, and SCENE is given too",
                          "leave one of them out");
  }
  names_ = scene::builtin_scene_names();
}

const std::string& SceneOptions::name_of(const scene::Scene& scene) const {
  return command_.count("--inertia") > 0 ? scene.shown_title() : scene.name;
}

void SceneOptions::add_inputs(twrench::system::FileList& files) const {
  for (const std::string& name : names_) files.add_input(name);
  for (const Loaded& scene : load()) {
    for (const std::filesystem::path& file : scene.robot_files) files.add_input(file);
    for (const std::filesystem::path& file : scene::input_files(scene.overridden)) {
      files.add_input(file);
    }
  }
}

SceneOptions::Loaded SceneOptions::load(const std::string& name) const {
  if (mesh::is_mesh_name(name)) return {mesh_.scene(name)};
  if (robot::is_robot_name(name)) {
    robot::JudgedRobot judged = robot_.read(name);
    warn_of_notes(judged);
    const std::size_t link = robot_.index(judged.robot);
    return {.original = scene::body_scene(robot_.link(), scene::link_body(judged, link)),
            .robot_files = std::move(judged.files)};
  }
  return {scene::load_scene(language_ ? scene::story_in(*language_, name, "--language") : name)};
}

void SceneOptions::set_length(scene::Scene& scene) const {
  if (!length_) return;
  const bool has_duration = command_.count("--duration") > 0;
  if (has_duration && command_.count("--speed") > 0) {
    throw InvalidArgument("--length", "--duration and --speed determine it already",
                          "leave out one of the three");
  }
  scene::set_video_length(scene, parse_number(*length_, "--length"),
                          has_duration ? scene::Kept::duration : scene::Kept::speed, "--length");
}

bool SceneOptions::is_body_given() const {
  const CLI::Option* inertia = command_.get_option_no_throw("--inertia");
  return command_.count("SCENE") > 0 || (inertia != nullptr && inertia->count() > 0);
}

void SceneOptions::require_interior(const scene::Scene& scene) const {
  scene::check_interior(scene, [&](const std::string& key) {
    const auto field = std::ranges::find(scene::fields(), key, &scene::Field::key);
    const std::string option = option_of(*field);
    const CLI::Option* given = command_.get_option_no_throw(option);
    return given != nullptr && given->count() > 0 ? option : scene.name + ": " + key;
  });
}

const std::vector<SceneOptions::Loaded>& SceneOptions::load() const {
  if (!loaded_.empty()) return loaded_;
  const bool has_mesh = std::ranges::any_of(names_, mesh::is_mesh_name);
  const bool has_robot = std::ranges::any_of(names_, robot::is_robot_name);
  std::vector<Loaded> all;
  for (const std::string& name : names_) {
    Loaded loaded = load(name);
    if (!has_mesh) mesh_.require_none();  // a wrong name is the first mistake
    if (!has_robot) robot_.require_none();
    scene::Scene& scene = loaded.overridden = loaded.original;
    for (const auto& override_value : overrides_) {
      override_value(scene);
      for (scene::Shot& shot : scene.shots) override_value(shot.scene);
    }
    require_interior(scene);
    for (const scene::Shot& shot : scene.shots) require_interior(shot.scene);
    recording_.apply(scene, is_body_given());
    scene::set_natural_times(scene);
    set_length(scene);
    // Neutral titles are alike, so the scene's name tells them apart.
    const bool is_neutral = scene.origins.title == scene::Origin::none && !scene.title.empty();
    if (is_neutral && names_.size() > 1) scene.title += ": " + scene.name;
    all.push_back(std::move(loaded));
  }
  return loaded_ = std::move(all);
}

std::vector<std::string> SceneOptions::words(std::size_t index) const {
  const std::string& name = names_.at(index);
  std::vector<std::string> words{name};
  std::vector<std::string> options;
  if (mesh::is_mesh_name(name)) options = mesh_.given();
  if (robot::is_robot_name(name)) options = robot_.given();
  words.insert(words.end(), options.begin(), options.end());
  return words;
}

const scene::Scene& SceneOptions::original(std::size_t index) const {
  return load().at(index).original;
}

void SceneOptions::require_drawable(const scene::Scene& scene) const {
  if (scene.shots.empty()) return;
  for (const char* option : {"--omega", "--inertia", "--duration", "--speed"}) {
    if (command_.count(option) == 0) continue;
    throw InvalidArgument(option, "each shot of " + scene.name + " has its own",
                          "change the shots in the scene file, or leave the option out");
  }
}

std::vector<scene::Scene> SceneOptions::scenes() const {
  std::vector<scene::Scene> scenes;
  for (const Loaded& loaded : load()) scenes.push_back(loaded.overridden);
  const bool as_json = is_progress_json(command_);
  // All scenes have the body of --inertia, so one warning is enough.
  const CLI::Option* inertia = command_.get_option_no_throw("--inertia");
  const bool is_given = inertia != nullptr && inertia->count() > 0;
  if (is_given) warn_of_unreal_moments("--inertia", *scenes.front().body.inertia, as_json);
  for (const scene::Scene& scene : scenes) {
    for (const std::string& note : scene::mesh_notes(scene)) warn(note, as_json);
    if (const auto& recording = scene.motion.recording) {
      for (const std::string& note : recording->notes) {
        warn(with_arguments(note, option_text), as_json);
      }
    }
    if (scene.body.inertia && !is_given) {
      warn_of_unreal_moments(scene.name, *scene.body.inertia, as_json);
    }
  }
  return scenes;
}

}  // namespace twrench::app

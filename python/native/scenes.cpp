#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <twrench/motion/trajectory.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/enumeration.h"
#include "base/words.h"
#include "body.h"
#include "errors.h"
#include "module.h"
#include "pickling.h"
#include "scene/fields.h"
#include "scene/languages.h"
#include "scene/limits.h"
#include "scene/materials.h"
#include "scene/mesh_scene.h"
#include "scene/scene_json.h"
#include "scene/scene_schema.h"
#include "scene/scene_values.h"
#include "scene/shown_recording.h"
#include "scene/video_length.h"
#include "timeline/film_timeline.h"

namespace twrench::python {
namespace {

namespace py = pybind11;
using scene::Scene;

/// A value, null included, as the text of JSON.
std::string get_value(const Scene& scene, const std::string& key) {
  for (const scene::Field& field : scene::fields()) {
    if (field.key != key) continue;
    const nlohmann::ordered_json value = field.get(scene);
    return value.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
  }
  throw InvalidArgument("scene", "has no key " + key);
}

void set_value(Scene& scene, const std::string& key, const std::string& json) {
  on_scene([&] {
    try {
      scene::set_value(scene, key, nlohmann::ordered_json::parse(json));
    } catch (const nlohmann::ordered_json::out_of_range&) {
      throw InvalidArgument(key, "is a number beyond those of double precision");
    }
  });
}

void set_video_length(Scene& scene, double length, bool keeps_duration) {
  on_scene([&] {
    scene::set_video_length(scene, length,
                            keeps_duration ? scene::Kept::duration : scene::Kept::speed, "length");
  });
}

/// The names that arguments of the package accept.
std::map<std::string, std::vector<std::string>> names_of_values() {
  std::vector<std::string> methods;
  for (const motion::Method& method : motion::methods()) methods.emplace_back(method.name);
  return {{"MethodName", methods},
          {"LanguageName", enumerator_names<scene::Language>()},
          {"SoundName", enumerator_names<scene::Sound>()},
          {"ThemeName", enumerator_names<scene::Theme>()},
          {"MaterialName", scene::material_names()},
          {"FrameName", enumerator_names<scene::Frame>()},
          {"ViewName", enumerator_names<scene::View>()},
          {"FeatureName", enumerator_names<scene::Feature>()},
          {"ForceName", enumerator_names<scene::Force>()},
          {"ShapeName", enumerator_names<scene::Equimomental>()}};
}

/// An absent weld is 0, an absent shell makes a solid, and without density and mass the density is
/// 1 g/cm^3.
Scene scene_of_mesh(const std::string& file, std::optional<double> scale,
                    std::optional<double> weld, std::optional<double> shell,
                    std::optional<double> density, std::optional<double> mass) {
  namespace limits = scene::limits;
  const py::gil_scoped_release others_run;
  return on_scene([&] {
    mesh::ReadOptions options;
    if (scale) options.scale = limits::check(limits::mesh_scale, "scale", *scale);
    if (weld) options.weld = limits::check(limits::length_or_none, "weld", *weld);
    if (shell) options.shell = limits::check(limits::length, "shell", *shell);
    return scene::mesh_scene(file, options, [&](double volume) {
      return mass ? limits::density_of_mass("mass", *mass, volume)
                  : limits::check(limits::density, "density", density.value_or(1.0));
    });
  });
}

std::vector<std::string> scene_notes(const Scene& scene) {
  std::vector<std::string> notes = mesh_notes(scene);
  if (const auto& recording = scene.motion.recording) {
    for (const std::string& note : recording->notes) {
      notes.push_back(with_arguments(note, argument_text));
    }
  }
  if (!scene.body.inertia) return notes;
  if (const auto note = scene::unreal_moments_note(scene.name, *scene.body.inertia)) {
    notes.push_back(*note);
  }
  return notes;
}

}  // namespace

void add_scenes(py::module_& module) {
  using scene::Field;
  py::class_<Field>(module, "Field")
      .def_readonly("table", &Field::table)
      .def_readonly("key", &Field::key)
      .def_readonly("help", &Field::help);
  module.def("fields", &scene::fields);
  module.def("state_of_scenes", [](const std::vector<Scene>& scenes) { return state_of(scenes); });
  module.def("scenes_with", &scenes_with);
  module.def("names", &names_of_values);
  module.def("scene_names", &scene::builtin_scene_names);
  module.def("scene_schema", [] { return scene::scene_schema().dump(-1, ' ', true); });
  py::class_<Scene>(module, "Scene")
      .def(py::init<const Scene&>())
      .def_static(
          "load",
          [](const std::string& name, const std::optional<std::string>& language) {
            const py::gil_scoped_release others_run;
            return on_scene([&] {
              if (!language) return scene::load_scene(name);
              return scene::load_scene(scene::story_in(*language, name, "language"));
            });
          },
          py::arg("name"), py::arg("language") = py::none())
      .def_static("of_mesh", &scene_of_mesh, py::arg("file"), py::arg("scale"), py::arg("weld"),
                  py::arg("shell"), py::arg("density"), py::arg("mass"))
      .def_static("parse",
                  [](const std::string& toml, const std::string& source) {
                    const py::gil_scoped_release others_run;
                    return on_scene([&] { return scene::parse_scene(toml, source); });
                  })
      .def_readonly("name", &Scene::name)
      .def_property_readonly("shows_recording",
                             [](const Scene& scene) { return scene.motion.recording != nullptr; })
      .def_property_readonly(
          "names_recording",
          [](const Scene& scene) { return scene.motion.recording_file != nullptr; })
      .def("get", &get_value)
      .def("set", &set_value)
      .def("set_number",  // which JSON cannot do for infinity
           [](Scene& scene, const std::string& key, double value) {
             on_scene([&] { scene::set_value(scene, key, value); });
           })
      .def_property_readonly("shown_title", &Scene::shown_title)
      .def("json", [](const Scene& scene) { return scene::scene_json(scene).dump(-1, ' ', true); })
      .def_property("body", &body_of,
                    [](Scene& scene, const Body& body) {
                      on_scene([&] { scene::set_body(scene, body.description); });
                    })
      .def("notes", &scene_notes)
      .def("input_files", &scene::input_files)
      .def("has_shots", [](const Scene& s) { return !s.shots.empty(); })
      .def("video_length", &Scene::video_length)
      .def("set_video_length", &set_video_length)
      .def("motion_times",
           [](const Scene& s) { return on_scene([&] { return timeline::motion_times(s); }); })
      .def("frame_count", [](const Scene& s) { return on_scene([&] { return s.frame_count(); }); });
}

}  // namespace twrench::python

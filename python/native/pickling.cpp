#include "pickling.h"

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "base/enumeration.h"
#include "body/dimensions.h"
#include "scene/fields.h"
#include "scene/limits.h"
#include "scene/recording_table.h"
#include "scene/scene_values.h"
#include "scene/shown_recording.h"
#include "solids.h"

namespace twrench::python {
namespace {

namespace py = pybind11;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using scene::Scene;
using Surface = std::shared_ptr<const body::TriangleMesh>;

/// Rows of as many numbers each as an array (n, width).
template <typename Number, int width = 3, typename Row>
py::array_t<Number> array_of(const std::vector<Row>& rows) {
  py::array_t<Number> array({static_cast<py::ssize_t>(rows.size()), py::ssize_t{width}});
  Number* to = array.mutable_data();
  for (const Row& row : rows) to = std::copy_n(row.data(), width, to);
  return array;
}

template <typename Number, typename Row, int width = 3>
std::vector<Row> rows_of(const py::handle& object) {
  const auto array = py::cast<py::array_t<Number, py::array::c_style>>(object);
  if (array.ndim() != 2 || array.shape(1) != width) throw py::cast_error("not an array of rows");
  std::vector<Row> rows(static_cast<std::size_t>(array.shape(0)));
  const Number* from = array.data();
  for (Row& row : rows) {
    std::copy_n(from, width, row.data());
    from += width;
  }
  return rows;
}

/// Writes states. Each mesh is written once, because pickle recognises repeated objects.
class Writer {
 public:
  py::tuple scene(const Scene& scene);
  py::tuple body(const scene::Body& body);

 private:
  py::object surface(const Surface& surface);
  py::object mesh(const body::Shape& shape);
  py::tuple part(const body::Part& part, const scene::PartDescription& description);

  std::map<Surface, py::object> surfaces_;
};

py::object Writer::surface(const Surface& surface) {
  py::object& written = surfaces_[surface];
  if (!written) {
    written = py::make_tuple(array_of<double>(surface->vertices),
                             array_of<std::uint32_t>(surface->triangles),
                             array_of<float>(surface->colors));
  }
  return written;
}

py::object Writer::mesh(const body::Shape& shape) {
  const auto* mesh = std::get_if<body::Mesh>(&shape);
  if (mesh == nullptr) return py::none();
  const auto& [volume, centroid, inertia] = mesh->integrals;
  return py::make_tuple(surface(mesh->surface), volume, centroid, inertia);
}

py::object source_state(const std::optional<scene::MeshSource>& source) {
  if (!source) return py::none();
  return py::make_tuple(source->file, source->path, source->scale, source->weld, source->sha256,
                        source->others);
}

py::tuple look_state(const scene::PartLook& look) {
  std::optional<std::array<int, 3>> color;
  if (look.color) color = {look.color->red, look.color->green, look.color->blue};
  return py::make_tuple(color, look.metallic, look.roughness, look.crease_angle);
}

py::tuple origins_state(const scene::Origins& origins) {
  py::list states;
  for (const auto member : scene::all_origins) states.append(static_cast<int>(origins.*member));
  return states;
}

py::tuple Writer::part(const body::Part& part, const scene::PartDescription& description) {
  return py::make_tuple(body::shape_name(part.shape), dimensions_of(part.shape), mesh(part.shape),
                        part.density, part.position, part.body_from_part, description.name,
                        look_state(description.look), source_state(description.mesh));
}

py::tuple Writer::body(const scene::Body& body) {
  py::list parts;
  for (std::size_t i = 0; i < body.parts.size(); ++i) {
    parts.append(part(body.parts[i], scene::description(body, i)));
  }
  return py::make_tuple(parts, body.inertia, static_cast<int>(body.drawn_as));
}

py::tuple sound_state(const scene::SoundFile& sound) {
  return py::make_tuple(sound.file, sound.path);
}

/// The time, the attitude (x, y, z, w) and the rates of an instant of a recorded motion.
using InstantRow = std::array<double, 8>;
using Instant = motion::RecordedMotion::Instant;

py::array_t<double> instants_state(const motion::RecordedMotion& motion) {
  std::vector<InstantRow> rows;
  for (const Instant& instant : motion.instants()) {
    InstantRow& row = rows.emplace_back(InstantRow{instant.t});
    std::copy_n(instant.X.coeffs().data(), 4, row.data() + 1);
    std::copy_n(instant.omega.data(), 3, row.data() + 5);
  }
  return array_of<double, 8>(rows);
}

py::object recording_state(const std::shared_ptr<const scene::ShownRecording>& shown) {
  if (!shown) return py::none();
  return py::make_tuple(shown->file, shown->path, instants_state(shown->motion),
                        shown->motion.longest_step(), shown->flip_times, shown->sha256,
                        shown->drift, shown->has_body, shown->verdict, shown->notes);
}

py::object recording_file_state(const std::shared_ptr<const scene::RecordingFile>& file) {
  if (!file) return py::none();
  return py::make_tuple(file->keys, file->path);
}

/// The fields of a scene. No method is called recorded_name, which stands first among the compared
/// motions of a scene that shows a recording.
py::dict values_state(Scene from) {
  if (from.motion.recording) std::erase(from.overlay.compare, scene::recorded_name);
  py::dict values;
  for (const scene::Field& field : scene::fields()) {
    const nlohmann::ordered_json value = field.get(from);
    if (!value.is_null()) values[field.key.c_str()] = py::bytes(value.dump());
  }
  return values;
}

py::tuple Writer::scene(const Scene& from) {
  py::list shots;
  for (const scene::Shot& shot : from.shots) {
    py::list speeds;
    for (const auto& [time, value] : shot.speed.points) speeds.append(py::make_tuple(time, value));
    shots.append(py::make_tuple(scene(shot.scene), shot.fade, shot.move, shot.start, speeds,
                                shot.place, sound_state(shot.narration), shot.continues));
  }
  return py::make_tuple(from.name, values_state(from), body(from.body), from.caption, from.length,
                        shots, origins_state(from.origins), sound_state(from.film.audio),
                        recording_state(from.motion.recording),
                        recording_file_state(from.motion.recording_file));
}

/// Throws the error of a damaged state, unless `is_right`.
void require(bool is_right) {
  if (!is_right) throw py::value_error("not a state that Writer writes");
}

double number_in(const scene::limits::Limit& limit, const py::handle& state) {
  const auto value = state.cast<double>();
  require(limit.low <= value && value <= limit.high);
  return value;
}

std::optional<double> number_or_none(const scene::limits::Limit& limit, const py::handle& state) {
  return state.is_none() ? std::nullopt : std::optional(number_in(limit, state));
}

Vector3d place_of(const py::handle& state) {
  return scene::limits::check(scene::limits::coordinate, "position", state.cast<Vector3d>());
}

/// A value of an enumeration from its number.
template <typename Enumeration>
Enumeration enumerator_of(const py::handle& state) {
  const auto number = state.cast<std::size_t>();
  require(number < enumerator_names<Enumeration>().size());
  return static_cast<Enumeration>(number);
}

/// Reads the states that Writer wrote.
class Reader {
 public:
  Scene scene(const py::tuple& state);
  scene::Body body(const py::tuple& state);

 private:
  scene::Shot shot(const py::tuple& state);
  Surface surface(const py::object& state);
  body::Shape shape(const py::tuple& part);

  std::map<PyObject*, Surface> surfaces_;
};

Surface Reader::surface(const py::object& state) {
  Surface& read = surfaces_[state.ptr()];
  if (!read) {
    const auto arrays = py::cast<py::tuple>(state);
    body::TriangleMesh mesh{rows_of<double, Vector3d>(arrays[0]),
                            rows_of<std::uint32_t, std::array<std::uint32_t, 3>>(arrays[1]),
                            rows_of<float, std::array<float, 3>>(arrays[2])};
    require(mesh.colors.empty() || mesh.colors.size() == mesh.vertices.size());
    read = std::make_shared<const body::TriangleMesh>(std::move(mesh));
  }
  return read;
}

body::Shape Reader::shape(const py::tuple& part) {
  const auto dimensions = part[1].cast<std::vector<double>>();
  for (const double dimension : dimensions) require(dimension >= 0 && std::isfinite(dimension));
  if (part[2].is_none()) return solid_called(part[0].cast<std::string>(), dimensions);
  const auto mesh = part[2].cast<py::tuple>();
  const body::SolidIntegrals integrals{mesh[1].cast<double>(), mesh[2].cast<Vector3d>(),
                                       mesh[3].cast<Matrix3d>()};
  require(std::isfinite(integrals.volume) && integrals.volume > 0 &&
          integrals.centroid.allFinite() && integrals.inertia.allFinite());
  const Surface own = surface(mesh[0]);
  const double shell = dimensions.at(0);
  // These throw if the surface is none of a body.
  static_cast<void>(shell > 0 ? body::shell_integrals(*own, shell) : body::solid_integrals(*own));
  return body::Mesh{own, shell, integrals};
}

scene::PartLook look_with(const py::tuple& state) {
  scene::PartLook look;
  if (const auto color = state[0].cast<std::optional<std::array<int, 3>>>()) {
    for (const int channel : *color) require(channel >= 0 && channel <= 255);
    look.color = Color{(*color)[0], (*color)[1], (*color)[2]};
  }
  look.metallic = number_or_none(scene::limits::fraction, state[1]);
  look.roughness = number_or_none(scene::limits::roughness, state[2]);
  look.crease_angle = number_in(scene::limits::crease, state[3]);
  return look;
}

std::optional<scene::MeshSource> source_with(const py::object& state) {
  if (state.is_none()) return std::nullopt;
  const auto values = state.cast<py::tuple>();
  scene::MeshSource source;
  source.file = values[0].cast<std::string>();
  source.path = values[1].cast<std::filesystem::path>();
  source.scale = values[2].cast<std::optional<double>>();
  source.weld = values[3].cast<double>();
  source.sha256 = values[4].cast<std::string>();
  source.others = values[5].cast<std::vector<std::filesystem::path>>();
  return source;
}

scene::Origins origins_with(const py::tuple& state) {
  scene::Origins origins;
  std::size_t next = 0;
  for (const auto member : scene::all_origins) {
    origins.*member = enumerator_of<scene::Origin>(state[next++]);
  }
  return origins;
}

scene::SoundFile sound_with(const py::tuple& state) {
  return {state[0].cast<std::string>(), state[1].cast<std::filesystem::path>()};
}

motion::RecordedMotion motion_with(const py::handle& state, double longest_step) {
  std::vector<Instant> instants;
  for (const InstantRow& row : rows_of<double, InstantRow, 8>(state)) {
    for (const double number : row) require(std::isfinite(number));
    require(instants.empty() ? row[0] == 0 : row[0] > instants.back().t);
    const Eigen::Quaterniond X(row.data() + 1);
    constexpr double round_off = 1e-9;
    require(std::abs(X.norm() - 1) < round_off);
    instants.push_back({row[0], X, Vector3d(row.data() + 5)});
  }
  require(longest_step > 0);
  return {std::move(instants), longest_step};
}

std::shared_ptr<const scene::ShownRecording> recording_with(const py::object& state) {
  if (state.is_none()) return nullptr;
  const auto values = state.cast<py::tuple>();
  return std::make_shared<const scene::ShownRecording>(
      scene::ShownRecording{.file = values[0].cast<std::string>(),
                            .path = values[1].cast<std::filesystem::path>(),
                            .motion = motion_with(values[2], values[3].cast<double>()),
                            .flip_times = values[4].cast<std::vector<double>>(),
                            .sha256 = values[5].cast<std::string>(),
                            .drift = values[6].cast<double>(),
                            .has_body = values[7].cast<bool>(),
                            .verdict = values[8].cast<std::string>(),
                            .notes = values[9].cast<std::vector<std::string>>()});
}

/// Sets the values that fields do not hold: the identity, and the name of a recorded motion.
void complete_with_recording(Scene& scene) {
  if (!scene.motion.attitude) scene.motion.attitude = Eigen::Quaterniond::Identity();
  std::vector<std::string>& compared = scene.overlay.compare;
  if (!compared.empty()) compared.insert(compared.begin(), scene::recorded_name);
}

std::shared_ptr<const scene::RecordingFile> recording_file_with(const py::object& state) {
  if (state.is_none()) return nullptr;
  const auto values = state.cast<py::tuple>();
  return std::make_shared<const scene::RecordingFile>(scene::recording_file(
      nlohmann::ordered_json::parse(values[0].cast<std::string>()),
      values[1].cast<std::filesystem::path>(), [](const std::string& key) { return key; }));
}

scene::Body Reader::body(const py::tuple& state) {
  scene::Body body;
  for (const py::handle& handle : state[0]) {
    const auto part = handle.cast<py::tuple>();
    const auto turn = part[5].cast<Matrix3d>();
    constexpr double round_off = 1e-9;
    require(turn.allFinite() && turn.isUnitary(round_off));
    const double density = part[3].cast<double>();
    require(density > 0 && std::isfinite(density));
    body.parts.push_back({shape(part), density, place_of(part[4]), turn});
    body.descriptions.push_back(
        {part[6].cast<std::string>(), look_with(part[7]), source_with(part[8])});
  }
  if (const auto inertia = state[1].cast<std::optional<Matrix3d>>()) {
    body.inertia = scene::limits::check_inertia("inertia", *inertia);
  }
  body.drawn_as = enumerator_of<scene::Equimomental>(state[2]);
  static_cast<void>(scene::mass_properties(body));  // throws for wrong dimensions and for no parts
  return body;
}

scene::Shot Reader::shot(const py::tuple& state) {
  namespace limits = scene::limits;
  const auto film = state[0].cast<py::tuple>();
  require(py::len(film[5]) == 0);  // a shot has no shots
  scene::Shot shot;
  shot.scene = scene(film);
  shot.fade = number_in(limits::shot_transition, state[1]);
  shot.move = number_in(limits::shot_transition, state[2]);
  shot.start = number_in(limits::shot_start, state[3]);
  for (const py::handle& handle : state[4]) {
    const auto point = handle.cast<py::tuple>();
    shot.speed.points.push_back({number_in({0, limits::shot_length.high}, point[0]),
                                 number_in(limits::shot_speed, point[1])});
  }
  require(shot.scene.length.has_value() && !shot.speed.points.empty() &&
          std::ranges::is_sorted(shot.speed.points, {}, &scene::SpeedCurve::Point::time));
  shot.place = state[5].cast<std::string>();
  shot.narration = sound_with(state[6].cast<py::tuple>());
  shot.continues = state[7].cast<bool>();
  return shot;
}

Scene Reader::scene(const py::tuple& state) {
  Scene made;
  made.name = state[0].cast<std::string>();
  const auto values = state[1].cast<py::dict>();
  for (const scene::Field& field : scene::fields()) {
    if (!values.contains(field.key)) continue;
    const auto text = values[field.key.c_str()].cast<std::string>();
    field.set(made, nlohmann::ordered_json::parse(text), field.key);
  }
  made.body = body(state[2]);
  Scene other;
  scene::set_body(other, made.body);  // throws for a body that no scene may have
  made.caption = state[3].cast<std::optional<std::string>>();
  made.length = number_or_none(scene::limits::shot_length, state[4]);
  for (const py::handle& handle : state[5]) {
    made.shots.push_back(shot(handle.cast<py::tuple>()));
  }
  made.origins = origins_with(state[6]);
  made.film.audio = sound_with(state[7].cast<py::tuple>());
  made.motion.recording = recording_with(state[8]);
  made.motion.recording_file = recording_file_with(state[9]);
  if (made.motion.recording) complete_with_recording(made);
  return made;
}

/// Calls `read`. Throws InvalidArgument about `what` if the state does not have the form that
/// Writer writes.
template <typename Read>
auto read_whole(const std::string& what, const Read& read) {
  const auto damaged = [&] {
    return InvalidArgument("the pickled " + what, "is damaged", "pickle the object again");
  };
  try {
    return read();
  } catch (const nlohmann::json::exception&) {
    throw damaged();
  } catch (const py::builtin_exception&) {
    throw damaged();
  } catch (const py::error_already_set&) {
    throw damaged();
  } catch (const Error&) {  // a value beyond the limits of a scene
    throw damaged();
  } catch (const std::out_of_range&) {
    throw damaged();
  }
}

}  // namespace

py::tuple state_of(const Body& body) { return Writer().body(body.description); }

Body body_with(const py::object& state) {
  return read_whole("body", [&] {
    const scene::Body description = Reader().body(state.cast<py::tuple>());
    const body::MassProperties properties = scene::mass_properties(description);
    return Body{description, properties};
  });
}

py::tuple state_of(const motion::FreeBody& body) {
  const auto& [wheel, energy_loss_time] = body.interior();
  return py::make_tuple(body.inertia(), body.omega(), body.attitude(), wheel, energy_loss_time);
}

motion::FreeBody free_body_with(const py::object& state) {
  return read_whole("motion", [&] {
    using State = std::tuple<Matrix3d, Vector3d, Matrix3d, Vector3d, double>;
    const auto [inertia, omega, attitude, wheel, energy_loss_time] = state.cast<State>();
    return motion::FreeBody(inertia, omega, attitude, {wheel, energy_loss_time});
  });
}

py::tuple state_of(const std::vector<Scene>& scenes) {
  Writer writer;
  py::list states;
  for (const Scene& scene : scenes) states.append(writer.scene(scene));
  return states;
}

std::vector<Scene> scenes_with(const py::object& state) {
  return read_whole("scene", [&] {
    Reader reader;
    std::vector<Scene> scenes;
    for (const py::handle& scene : state.cast<py::tuple>()) {
      scenes.push_back(reader.scene(scene.cast<py::tuple>()));
    }
    return scenes;
  });
}

}  // namespace twrench::python

#include "pickling.h"

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "body/dimensions.h"
#include "scene/fields.h"
#include "solids.h"

namespace twrench::python {
namespace {

namespace py = pybind11;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using scene::Scene;
using Surface = std::shared_ptr<const body::TriangleMesh>;

/// Rows of three numbers each as an array (n, 3).
template <typename Number, typename Row>
py::array_t<Number> array_of(const std::vector<Row>& rows) {
  py::array_t<Number> array({static_cast<py::ssize_t>(rows.size()), py::ssize_t{3}});
  Number* to = array.mutable_data();
  for (const Row& row : rows) to = std::copy_n(row.data(), 3, to);
  return array;
}

template <typename Number, typename Row>
std::vector<Row> rows_of(const py::handle& object) {
  const auto array = py::cast<py::array_t<Number, py::array::c_style>>(object);
  if (array.ndim() != 2 || array.shape(1) != 3) throw py::cast_error("not an array (n, 3)");
  std::vector<Row> rows(static_cast<std::size_t>(array.shape(0)));
  const Number* from = array.data();
  for (Row& row : rows) {
    std::copy_n(from, 3, row.data());
    from += 3;
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

py::tuple Writer::scene(const Scene& from) {
  py::dict values;
  for (const scene::Field& field : scene::fields()) {
    const nlohmann::ordered_json value = field.get(from);
    if (!value.is_null()) values[field.key.c_str()] = py::bytes(value.dump());
  }
  py::list shots;
  for (const scene::Shot& shot : from.shots) {
    py::list speeds;
    for (const auto& [time, value] : shot.speed.points) speeds.append(py::make_tuple(time, value));
    shots.append(
        py::make_tuple(scene(shot.scene), shot.fade, shot.move, shot.start, speeds, shot.place));
  }
  return py::make_tuple(from.name, values, body(from.body), from.caption, from.length, shots,
                        origins_state(from.origins));
}

/// Reads the states that Writer wrote.
class Reader {
 public:
  Scene scene(const py::tuple& state);
  scene::Body body(const py::tuple& state);

 private:
  Surface surface(const py::object& state);
  body::Shape shape(const py::tuple& part);

  std::map<PyObject*, Surface> surfaces_;
};

Surface Reader::surface(const py::object& state) {
  Surface& read = surfaces_[state.ptr()];
  if (!read) {
    const auto arrays = py::cast<py::tuple>(state);
    read = std::make_shared<const body::TriangleMesh>(
        body::TriangleMesh{rows_of<double, Vector3d>(arrays[0]),
                           rows_of<std::uint32_t, std::array<std::uint32_t, 3>>(arrays[1]),
                           rows_of<float, std::array<float, 3>>(arrays[2])});
  }
  return read;
}

body::Shape Reader::shape(const py::tuple& part) {
  const auto dimensions = part[1].cast<std::vector<double>>();
  if (part[2].is_none()) return solid_called(part[0].cast<std::string>(), dimensions);
  const auto mesh = part[2].cast<py::tuple>();
  const body::SolidIntegrals integrals{mesh[1].cast<double>(), mesh[2].cast<Vector3d>(),
                                       mesh[3].cast<Matrix3d>()};
  return body::Mesh{surface(mesh[0]), dimensions.at(0), integrals};
}

scene::PartLook look_with(const py::tuple& state) {
  scene::PartLook look;
  if (const auto color = state[0].cast<std::optional<std::array<int, 3>>>()) {
    look.color = Color{(*color)[0], (*color)[1], (*color)[2]};
  }
  look.metallic = state[1].cast<std::optional<double>>();
  look.roughness = state[2].cast<std::optional<double>>();
  look.crease_angle = state[3].cast<double>();
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
    origins.*member = static_cast<scene::Origin>(state[next++].cast<int>());
  }
  return origins;
}

scene::Body Reader::body(const py::tuple& state) {
  scene::Body body;
  for (const py::handle& handle : state[0]) {
    const auto part = handle.cast<py::tuple>();
    body.parts.push_back(
        {shape(part), part[3].cast<double>(), part[4].cast<Vector3d>(), part[5].cast<Matrix3d>()});
    body.descriptions.push_back(
        {part[6].cast<std::string>(), look_with(part[7]), source_with(part[8])});
  }
  body.inertia = state[1].cast<std::optional<Matrix3d>>();
  body.drawn_as = static_cast<scene::Equimomental>(state[2].cast<int>());
  return body;
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
  made.caption = state[3].cast<std::optional<std::string>>();
  made.length = state[4].cast<std::optional<double>>();
  for (const py::handle& handle : state[5]) {
    const auto told = handle.cast<py::tuple>();
    scene::Shot shot;
    shot.scene = scene(told[0]);
    shot.fade = told[1].cast<double>();
    shot.move = told[2].cast<double>();
    shot.start = told[3].cast<double>();
    for (const auto& [time, value] : told[4].cast<std::vector<std::pair<double, double>>>()) {
      shot.speed.points.push_back({time, value});
    }
    shot.place = told[5].cast<std::string>();
    made.shots.push_back(std::move(shot));
  }
  made.origins = origins_with(state[6]);
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
  } catch (const std::out_of_range&) {
    throw damaged();
  }
}

}  // namespace

py::tuple state_of(const Body& body) { return Writer().body(body.description); }

Body body_with(const py::tuple& state) {
  return read_whole("body", [&] {
    const scene::Body description = Reader().body(state);
    return Body{description, scene::mass_properties(description)};
  });
}

py::tuple state_of(const std::vector<Scene>& scenes) {
  Writer writer;
  py::list states;
  for (const Scene& scene : scenes) states.append(writer.scene(scene));
  return states;
}

std::vector<Scene> scenes_with(const py::tuple& state) {
  return read_whole("scene", [&] {
    Reader reader;
    std::vector<Scene> scenes;
    for (const py::handle& scene : state) scenes.push_back(reader.scene(scene.cast<py::tuple>()));
    return scenes;
  });
}

}  // namespace twrench::python

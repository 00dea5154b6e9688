#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <twrench/math/so3.h>
#include <twrench/motion/free_body.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/color.h"
#include "base/enumeration.h"
#include "base/require.h"
#include "body.h"
#include "mesh/mesh_file.h"
#include "module.h"
#include "pickling.h"
#include "scene/limits.h"
#include "scene/materials.h"
#include "scene/mesh_files.h"
#include "solids.h"

namespace twrench::python {
namespace {

namespace py = pybind11;
using Eigen::Matrix3d;
using Eigen::Vector3d;
template <typename Number>
using ArrayOf = py::array_t<Number, py::array::c_style>;

/// A shape, and the file of a mesh.
struct Shape {
  body::Shape shape;
  std::optional<scene::MeshSource> source = {};
  std::vector<std::string> notes = {};
};

/// A solid of the package, converted to a part.
struct Part {
  body::Part part;
  scene::PartDescription description;
};

Shape make_solid(const std::string& name, const std::vector<double>& numbers) {
  return {solid_called(name, numbers)};
}

Shape mesh_of_file(const std::string& file, std::optional<double> scale, double weld,
                   double shell) {
  const py::gil_scoped_release others_run;
  scene::MeshFiles files = scene::MeshFiles::beside("");
  const auto& [shape, source, notes] =
      files.read(file, {.scale = scale, .weld = weld, .shell = shell});
  return {shape, source, notes};
}

Shape mesh_of_arrays(const ArrayOf<double>& vertices, const ArrayOf<std::uint32_t>& triangles,
                     const ArrayOf<float>& colors, std::optional<double> scale, double weld,
                     double shell) {
  body::TriangleMesh mesh;
  const auto count = [](const auto& array) { return static_cast<std::size_t>(array.shape(0)); };
  mesh.vertices.resize(count(vertices));
  mesh.triangles.resize(count(triangles));
  mesh.colors.resize(count(colors));
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    mesh.vertices[i] = Eigen::Map<const Vector3d>(vertices.data() + 3 * i);
  }
  std::copy_n(triangles.data(), triangles.size(), mesh.triangles.data()->data());
  std::copy_n(colors.data(), colors.size(), mesh.colors.data()->data());
  const py::gil_scoped_release others_run;
  mesh::MeshFile checked =
      mesh::checked_mesh("mesh", std::move(mesh), {.scale = scale, .weld = weld, .shell = shell});
  return {std::move(checked.shape), {}, std::move(checked.notes)};
}

scene::PartLook make_look(const std::string& material, const std::string& color,
                          std::optional<double> metallic, std::optional<double> roughness,
                          std::optional<double> crease) {
  scene::PartLook look;
  if (!material.empty()) set_material(look, scene::find_material(material, "material"));
  if (!color.empty()) look.color = parse_color(color, "color");
  if (metallic) look.metallic = check(scene::limits::fraction, "metallic", *metallic);
  if (roughness) look.roughness = check(scene::limits::roughness, "roughness", *roughness);
  if (crease) look.crease_angle = check(scene::limits::crease, "crease", *crease);
  return look;
}

Part make_part(const Shape& shape, std::optional<double> density, double mass,
               const Vector3d& position, const std::optional<Vector3d>& axis,
               const std::optional<Vector3d>& rotation, const std::string& name,
               const scene::PartLook& look) {
  const Matrix3d turn = axis       ? body::frame_with_z_along(*axis)
                        : rotation ? so3::exp(*rotation)
                                   : Matrix3d::Identity();
  const double given = density ? *density : mass / body::volume(shape.shape);
  return {{shape.shape, given, position, turn}, {name, look, shape.source, shape.notes}};
}

Body body_from_parts(const std::vector<Part>& parts) {
  scene::Body description;
  for (const Part& part : parts) {
    description.parts.push_back(part.part);
    description.descriptions.push_back(part.description);
  }
  // Not in the braces below, because GCC 12 destroys the preceding members twice if it throws
  // there.
  const body::MassProperties properties = body::mass_properties(description.parts);
  return {description, properties};
}

/// Throws InvalidArgument about "inertia" unless it is symmetric and positive definite.
Body body_from_inertia(const Matrix3d& inertia, const std::string& shape) {
  scene::Body description;
  description.inertia = motion::FreeBody(inertia, Vector3d::Zero()).inertia();
  description.drawn_as = find_enumerator<scene::Equimomental>(shape, "shape");
  const body::MassProperties properties = scene::mass_properties(description);
  return {description, properties};
}

Body body_from_moments(const Vector3d& moments, const std::string& shape) {
  for (const double moment : moments) require_positive("moments", moment);
  return body_from_inertia(moments.asDiagonal(), shape);
}

std::vector<std::string> body_notes(const Body& body) {
  std::vector<std::string> notes = mesh_notes(body.description);
  if (!body.description.inertia) return notes;
  const auto note = scene::unreal_moments_note("Body", *body.description.inertia);
  if (note) notes.push_back(*note);
  return notes;
}

}  // namespace

void add_bodies(py::module_& module) {
  py::class_<Shape>(module, "Shape").def_property_readonly("volume", [](const Shape& s) {
    return body::volume(s.shape);
  });
  module.attr("shapes") = shapes();
  module.def("solid", &make_solid);
  module.def("mesh_of_file", &mesh_of_file);
  module.def("mesh_of_arrays", &mesh_of_arrays);
  module.def("unit_length", &mesh::unit_length);
  module.def("is_mesh_name", [](const std::string& name) { return mesh::is_mesh_name(name); });
  py::class_<scene::PartLook>(module, "Look").def(py::init(&make_look));
  py::class_<Part>(module, "Part").def(py::init(&make_part));
  py::class_<Body>(module, "Body")
      .def_static("from_parts", &body_from_parts)
      .def_static("from_moments", &body_from_moments)
      .def_static("from_inertia", &body_from_inertia)
      .def(py::pickle([](const Body& b) -> py::object { return state_of(b); }, &body_with))
      .def_property_readonly("notes", &body_notes)
      .def_property_readonly("mass", [](const Body& b) { return b.properties.mass; })
      .def_property_readonly("centre_of_mass",
                             [](const Body& b) { return b.properties.centre_of_mass; })
      .def_property_readonly("inertia", [](const Body& b) { return b.properties.inertia; })
      .def("inertia_about",
           [](const Body& b, const Vector3d& point) {
             return body::inertia_about(b.properties, point);
           })
      .def_property_readonly("moments", [](const Body& b) { return b.properties.moments; })
      .def_property_readonly("axes", [](const Body& b) { return b.properties.axes; });
}

}  // namespace twrench::python

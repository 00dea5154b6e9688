#include <pybind11/eigen.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/enumeration.h"
#include "base/words.h"
#include "body.h"
#include "errors.h"
#include "film/robot_pictures.h"
#include "module.h"
#include "robot/repair.h"
#include "robot/report.h"
#include "scene/link_scene.h"

namespace twrench::python {
namespace {

namespace py = pybind11;

/// A text of the file as Python's str. Bytes that are not UTF-8 are escaped.
py::str str_of(const std::string& text) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "backslashreplace"));
}

py::dict finding_of(const robot::Finding& finding) {
  py::dict result;
  result["fault"] = std::string(enumerator_name(finding.fault));
  result["text"] = str_of(finding.text);
  result["misfit"] = finding.misfit;
  result["geometry"] = str_of(finding.model);
  return result;
}

py::list findings_of(const std::vector<robot::Finding>& findings) {
  py::list result;
  for (const robot::Finding& finding : findings) result.append(finding_of(finding));
  return result;
}

/// The judgement on each link as keyword arguments of RobotLink.
py::list links_of(const robot::JudgedRobot& judged) {
  py::list result;
  for (std::size_t i = 0; i < judged.robot.links.size(); ++i) {
    const robot::Diagnosis& diagnosis = judged.diagnoses[i];
    py::dict link;
    link["name"] = str_of(judged.robot.links[i].name);
    link["line"] = judged.robot.links[i].line;
    link["verdict"] = std::string(enumerator_name(diagnosis.verdict));
    link["mass"] = diagnosis.body.mass;
    link["centre_of_mass"] = diagnosis.body.centre;
    link["inertia"] = diagnosis.body.inertia;
    link["principal_moments"] = diagnosis.moments;
    link["faults"] = findings_of(diagnosis.faults);
    link["mistakes"] = findings_of(diagnosis.mistakes);
    result.append(std::move(link));
  }
  return result;
}

robot::JudgedRobot judge(const std::filesystem::path& file,
                         const std::vector<std::filesystem::path>& packages) {
  const py::gil_scoped_release others_run;
  return robot::judge_robot(robot::read_robot(file), packages);
}

py::list notes_of(const robot::JudgedRobot& judged) {
  py::list notes;
  for (const std::string& note : judged.notes)
    notes.append(str_of(with_arguments(note, argument_text)));
  return notes;
}

/// The text of the repaired file, the changes, and the links that were not repaired, each with its
/// reason.
py::tuple repaired(const robot::JudgedRobot& judged, bool from_geometry) {
  const robot::Repair repair = robot::repair(judged, from_geometry);
  py::list changes, unrepaired;
  for (const robot::Change& change : repair.changes)
    changes.append(py::make_tuple(str_of(change.link), str_of(change.reason)));
  for (const robot::Unrepaired& link : repair.unrepaired)
    unrepaired.append(
        py::make_tuple(str_of(link.link), str_of(with_arguments(link.reason, argument_text))));
  return py::make_tuple(py::bytes(repair.text), changes, unrepaired);
}

/// The judgement as a page, with pictures.
std::string page_of_robot(const robot::JudgedRobot& judged, bool from_geometry) {
  const py::gil_scoped_release others_run;
  const robot::Repair repair = robot::repair(judged, from_geometry);
  return robot::robot_html(judged, repair, film::robot_pictures(judged, repair, {}), argument_text);
}

Body link_as_body(const robot::JudgedRobot& judged, std::size_t link) {
  scene::Body description = scene::link_body(judged, link);
  const body::MassProperties properties = scene::mass_properties(description);
  return {std::move(description), properties};
}

}  // namespace

void add_robots(py::module_& module) {
  py::class_<robot::JudgedRobot>(module, "JudgedRobot")
      .def(py::init(&judge))
      .def_property_readonly("name",
                             [](const robot::JudgedRobot& j) { return str_of(j.robot.name); })
      .def_property_readonly(
          "format",
          [](const robot::JudgedRobot& j) { return std::string(enumerator_name(j.robot.format)); })
      .def_property_readonly("notes", &notes_of)
      .def_property_readonly("links", &links_of)
      .def("repaired", &repaired)
      .def("page", &page_of_robot)
      .def_property_readonly("inputs",
                             [](const robot::JudgedRobot& j) {
                               std::vector<std::filesystem::path> files = j.files;
                               files.push_back(j.robot.file);
                               return files;
                             })
      .def("body", &link_as_body);
}

}  // namespace twrench::python

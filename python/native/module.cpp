// twrench._native: the interface between the package's Python sources and the libraries. The Python
// sources check and convert arguments, and document units and shapes.
#include "module.h"

#include "errors.h"

PYBIND11_MODULE(_native, module) {
  module.attr("version") = TWRENCH_VERSION;
  twrench::python::register_errors();
  twrench::python::add_bodies(module);
  twrench::python::add_robots(module);
  twrench::python::add_cases(module);
  twrench::python::add_checks(module);
  twrench::python::add_dynamics(module);
  twrench::python::add_study(module);
  twrench::python::add_scenes(module);
  twrench::python::add_pictures(module);
  twrench::python::add_outputs(module);
}

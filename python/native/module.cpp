// twrench._native: the libraries as the package's Python sources use them. Arguments come checked
// and converted from there; docstrings, units and shapes are there too.
#include "module.h"

#include "errors.h"

PYBIND11_MODULE(_native, module) {
  module.attr("version") = TWRENCH_VERSION;
  twrench::python::register_errors();
  twrench::python::add_bodies(module);
  twrench::python::add_cases(module);
  twrench::python::add_dynamics(module);
  twrench::python::add_study(module);
  twrench::python::add_scenes(module);
  twrench::python::add_pictures(module);
}

#pragma once

#include <pybind11/pybind11.h>

namespace twrench::python {

// Each adds a part of the module twrench._native.

void add_bodies(pybind11::module_& module);
void add_robots(pybind11::module_& module);
void add_cases(pybind11::module_& module);
void add_checks(pybind11::module_& module);
void add_dynamics(pybind11::module_& module);
void add_study(pybind11::module_& module);
void add_scenes(pybind11::module_& module);
void add_pictures(pybind11::module_& module);
void add_outputs(pybind11::module_& module);

}  // namespace twrench::python

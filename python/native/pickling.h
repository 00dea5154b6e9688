#pragma once

#include <pybind11/pybind11.h>
#include <twrench/motion/free_body.h>

#include <vector>

#include "body.h"

namespace twrench::python {

// Conversion of a body, a motion's body and scenes to states in Python's own types, and back.
// States are exact and do not depend on the files that were read. Parts that share a mesh, even in
// different scenes, share it again.

pybind11::tuple state_of(const Body& body);
Body body_with(const pybind11::object& state);

pybind11::tuple state_of(const motion::FreeBody& body);
motion::FreeBody free_body_with(const pybind11::object& state);

pybind11::tuple state_of(const std::vector<scene::Scene>& scenes);
std::vector<scene::Scene> scenes_with(const pybind11::object& state);

}  // namespace twrench::python

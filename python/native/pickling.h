#pragma once

#include <pybind11/pybind11.h>

#include "body.h"

namespace twrench::python {

// What a body and a scene are, in Python's own types, exactly and without the files that they were
// read from; and the body or the scene that has that state. Parts that share a mesh share it again.

pybind11::tuple state_of(const Body& body);
Body body_with(const pybind11::tuple& state);

pybind11::tuple state_of(const scene::Scene& scene);
scene::Scene scene_with(const pybind11::tuple& state);

}  // namespace twrench::python

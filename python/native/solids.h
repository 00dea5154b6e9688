#pragma once

#include <twrench/body/shape.h>

#include <Eigen/Core>
#include <string>
#include <vector>

namespace twrench::python {

/// Returns the shape with that name, but for a mesh, whose dimensions are in the order of
/// scene::for_dimensions().
body::Shape solid_called(const std::string& name, const std::vector<double>& dimensions);

/// Returns the dimensions of a shape in that order.
std::vector<double> dimensions_of(const body::Shape& shape);

}  // namespace twrench::python

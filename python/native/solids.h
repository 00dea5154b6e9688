#pragma once

#include <twrench/body/shape.h>

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace twrench::python {

/// The key of a dimension, and the count of its numbers.
using Dimension = std::pair<std::string, std::size_t>;

/// Returns the dimensions of all shapes, by the name of the shape.
std::map<std::string, std::vector<Dimension>> shapes();

/// Returns the solid with that name, which is not "mesh", from the numbers of its dimensions in
/// that order. Throws InvalidArgument for an unknown name.
body::Shape solid_called(const std::string& name, const std::vector<double>& numbers);

/// Returns the numbers of a shape's dimensions.
std::vector<double> dimensions_of(body::Shape shape);

}  // namespace twrench::python

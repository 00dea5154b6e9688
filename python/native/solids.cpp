#include "solids.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <optional>

#include "body/dimensions.h"

namespace twrench::python {

std::map<std::string, std::vector<Dimension>> shapes() {
  std::map<std::string, std::vector<Dimension>> result;
  for (body::Shape shape : body::all_shapes()) {
    std::vector<Dimension>& keys = result[body::shape_name(shape)];
    for (const body::Dimension& dimension : body::dimensions(shape)) {
      keys.emplace_back(dimension.key, dimension.values.size());
    }
  }
  return result;
}

body::Shape solid_called(const std::string& name, const std::vector<double>& numbers) {
  std::optional<body::Shape> solid = body::shape_named(name);
  // A mesh cannot be made from numbers alone.
  if (!solid || std::holds_alternative<body::Mesh>(*solid)) {
    throw InvalidArgument("shape", fmt::format("'{}' is not the name of a solid", name));
  }
  std::size_t next = 0;
  for (const body::Dimension& dimension : body::dimensions(*solid)) {
    for (double& value : dimension.values) value = numbers.at(next++);
  }
  return *solid;
}

std::vector<double> dimensions_of(body::Shape shape) {
  std::vector<double> numbers;
  for (const body::Dimension& dimension : body::dimensions(shape)) {
    numbers.insert(numbers.end(), dimension.values.begin(), dimension.values.end());
  }
  return numbers;
}

}  // namespace twrench::python

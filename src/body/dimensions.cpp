#include "body/dimensions.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/require.h"
#include "body/shape_functions.h"

namespace twrench::body {
namespace {

void require_less(const std::string& quantity, double value, const std::string& other,
                  double limit) {
  if (value < limit) return;
  throw InvalidArgument(quantity,
                        fmt::format("is {}, but must be less than {}, {}", value, other, limit));
}

template <std::size_t... i>
std::vector<Shape> one_of_each(std::index_sequence<i...>) {
  return {Shape(std::in_place_index<i>)...};
}

}  // namespace

Dimension length(const char* key, double& value) { return {key, {&value, 1}}; }

Dimension length_or_zero(const char* key, double& value) { return {key, {&value, 1}, true}; }

Dimension smaller_length(const char* key, double& value, const char* greater_key,
                         const double& greater) {
  return {key, {&value, 1}, false, &greater, greater_key};
}

Dimension lengths(const char* key, Eigen::Vector3d& values) { return {key, {values.data(), 3}}; }

std::vector<Dimension> dimensions(Shape& shape) {
  return std::visit([](auto& solid) { return shapes::dimensions(solid); }, shape);
}

void require_dimensions(Shape shape) {
  const std::vector<Dimension> all = dimensions(shape);
  for (const Dimension& dimension : all) {
    // A dimension that must exceed another one is compared with it below. The smaller one is
    // checked here.
    if (std::ranges::find(all, dimension.values.data(), &Dimension::greater) != all.end()) continue;
    for (const double value : dimension.values) {
      if (value == 0.0 && dimension.may_be_zero) continue;
      require_positive(dimension.key.c_str(), value);
    }
  }
  for (const Dimension& dimension : all) {
    if (dimension.greater == nullptr) continue;
    require_finite(dimension.greater_key.c_str(), *dimension.greater);
    require_less(dimension.key, dimension.values[0], dimension.greater_key, *dimension.greater);
  }
}

std::vector<Shape> all_shapes() {
  return one_of_each(std::make_index_sequence<std::variant_size_v<Shape>>());
}

std::string shape_name(const Shape& shape) {
  return std::visit([](const auto& solid) { return shapes::name(solid); }, shape);
}

std::optional<Shape> shape_named(const std::string& name) {
  std::vector<Shape> all = all_shapes();
  const auto found = std::ranges::find(all, name, shape_name);
  return found == all.end() ? std::nullopt : std::optional(*found);
}

}  // namespace twrench::body

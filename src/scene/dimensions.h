#pragma once

#include <twrench/body/shape.h>

#include <concepts>
#include <functional>
#include <string>
#include <type_traits>

#include "scene/limits.h"

// The dimensions of the shapes by the keys that a scene file has for them, from which reading
// them, writing them as JSON, and holding them against their limits are made.

namespace twrench::scene {

template <typename T, typename Shape>
concept Is = std::same_as<std::remove_const_t<T>, Shape>;

// Each calls visit(key, value, limit) for each dimension, a number or a vector of numbers in cm. A
// file may leave out one whose limit begins at 0.

void for_dimensions(Is<body::Cylinder> auto& cylinder, const auto& visit) {
  visit("radius", cylinder.radius, limits::length);
  visit("length", cylinder.length, limits::length);
}

void for_dimensions(Is<body::Box> auto& box, const auto& visit) {
  visit("size", box.size, limits::length);
}

void for_dimensions(Is<body::Ellipsoid> auto& ellipsoid, const auto& visit) {
  visit("radii", ellipsoid.radii, limits::length);
}

void for_dimensions(Is<body::Cone> auto& cone, const auto& visit) {
  visit("radius", cone.radius, limits::length);
  visit("length", cone.length, limits::length);
  visit("top_radius", cone.top_radius, limits::length_or_none);
}

void for_dimensions(Is<body::Torus> auto& torus, const auto& visit) {
  visit("radius", torus.radius, limits::length);
  visit("tube_radius", torus.tube_radius, limits::length);
}

void for_dimensions(Is<body::Capsule> auto& capsule, const auto& visit) {
  visit("radius", capsule.radius, limits::length);
  visit("length", capsule.length, limits::length);
}

void for_dimensions(Is<body::Tube> auto& tube, const auto& visit) {
  visit("radius", tube.radius, limits::length);
  visit("inner_radius", tube.inner_radius, limits::length);
  visit("length", tube.length, limits::length);
}

void for_dimensions(Is<body::Mesh> auto& mesh, const auto& visit) {
  visit("shell", mesh.shell, limits::length_or_none);
}

/// Returns the name that a scene file has for a shape.
std::string shape_name(const body::Shape& shape);

/// Says where the value of a key stands, for messages.
using PlaceOf = std::function<std::string(const std::string& key)>;

/// Throws OutOfRange unless the dimensions are within their limits and a hole is smaller than what
/// it is in.
void check_dimensions(const body::Shape& shape, const PlaceOf& place_of);

}  // namespace twrench::scene

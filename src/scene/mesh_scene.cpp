#include "scene/mesh_scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "body/moments.h"
#include "scene/dimensions.h"
#include "scene/limits.h"
#include "scene/mesh_files.h"
#include "scene/natural_times.h"

namespace twrench::scene {
namespace {

using Eigen::Vector3d;

/// Rounds to that many decimals, so that a scene is the same on every machine. Zero is positive.
double round_to(int decimals, double value) {
  const double unit = std::pow(10, decimals);
  return std::round(value * unit) / unit + 0.0;
}

Vector3d round_each(const Vector3d& v) {
  return v.unaryExpr([](double component) { return round_to(6, component); });
}

/// An angular velocity of 1 rad/s at that angle to an axis of symmetry. Neither its sign nor its
/// direction around the axis depends on the rounding of the other two principal axes.
Vector3d tilted(const Vector3d& axis, double angle) {
  const Vector3d clean = round_each(axis);
  Eigen::Index largest = 0, least = 0;
  clean.cwiseAbs().maxCoeff(&largest);
  clean.cwiseAbs().minCoeff(&least);
  const Vector3d forward = clean[largest] < 0 ? Vector3d(-axis) : axis;
  const Vector3d unit = Vector3d::Unit(least);
  const Vector3d across = (unit - forward.dot(unit) * forward).normalized();
  return std::cos(angle) * forward + std::sin(angle) * across;
}

/// The name as a title on one line.
std::string title_of(std::string name) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
  std::ranges::replace_if(name, is_control, ' ');
  return name;
}

Body body_of(const std::string& file, const mesh::ReadOptions& options,
             const std::function<double(double volume)>& density_of) {
  MeshEntry entry =
      mesh_entry(mesh::read_mesh(std::filesystem::path(file), options), file, file, options);
  check_dimensions(entry.shape, [&](const std::string& key) { return file + ": " + key; });
  Body body;
  body.parts.push_back({entry.shape, density_of(body::volume(entry.shape)), Vector3d::Zero(),
                        Eigen::Matrix3d::Identity()});
  PartDescription description;
  description.mesh = std::move(entry.source);
  description.notes = std::move(entry.notes);
  body.descriptions.push_back(std::move(description));
  limits::check_moments(file, mass_properties(body).moments);
  return body;
}

/// The azimuth in rad from which the angular momentum L lies across the picture.
double azimuth_across(const Vector3d& L) {
  constexpr double upright = 0.1;
  const bool is_upright = std::hypot(L.x(), L.z()) < upright * L.norm();
  return is_upright ? 0.0 : round_to(3, std::atan2(-L.z(), L.x()));
}

}  // namespace

Vector3d natural_omega(const body::MassProperties& body) {
  constexpr double push = 0.05, tilt = 0.3;  // rad/s; rad
  constexpr double ball = 0.01;
  const Vector3d& moments = body.moments;
  if (moments[2] - moments[0] <= ball * moments[2]) return Vector3d::UnitX();
  const bool is_flat = body::are_equal_moments(moments[0], moments[1]);
  if (is_flat || body::are_equal_moments(moments[1], moments[2])) {
    return round_each(tilted(body.axes.col(is_flat ? 2 : 0), tilt));
  }
  const bool differs_below = moments[1] * moments[1] > moments[0] * moments[2];
  return round_each(body.axes.col(1) + push * body.axes.col(differs_below ? 0 : 2));
}

Scene body_scene(const std::string& name, Body body) {
  Scene scene;
  scene.name = name;
  std::ranges::replace(scene.name, '/', '-');
  scene.title = title_of(name);
  scene.body = std::move(body);
  const body::MassProperties properties = mass_properties(scene.body);
  scene.motion.omega = natural_omega(properties);
  scene.camera.azimuth = azimuth_across(properties.inertia * scene.motion.omega);
  scene.origins.title = Origin::scene;
  set_natural_times(scene);
  return scene;
}

Scene mesh_scene(const std::string& file, const mesh::ReadOptions& options,
                 const std::function<double(double volume)>& density_of) {
  return body_scene(std::filesystem::path(file).stem().string(),
                    body_of(file, options, density_of));
}

}  // namespace twrench::scene

#pragma once

#include <functional>
#include <string>

#include "mesh/mesh_file.h"
#include "scene/scene.h"

namespace twrench::scene {

/// Returns an angular velocity in rad/s, in body axes, whose motion is typical of the body: it
/// spins at 1 rad/s about its intermediate axis, with a small push along the axis whose moment
/// differs more, so that it turns over. A body with an axis of symmetry (two moments that differ by
/// less than a ten-thousandth) spins about an axis 0.3 rad away from it, so that it wobbles. A ball
/// (three moments that differ by less than a hundredth), which would take a hundred turns to turn
/// over or to wobble, spins about its x axis.
Eigen::Vector3d natural_omega(const body::MassProperties& body);

/// Returns the scene of a body: with that name and title, natural omega and times, and a camera
/// from which the momentum lies across the picture. A '/' in the name becomes '-', because files
/// are named after it.
Scene body_scene(const std::string& name, Body body);

/// Returns the scene of a single mesh. It is named after the file. See body_scene(). `density_of`
/// returns the density in
/// g/cm^3 for a volume in cm^3. Throws as mesh::read_mesh() does, and InvalidArgument if a scene
/// file could not contain that part.
Scene mesh_scene(const std::string& file, const mesh::ReadOptions& options,
                 const std::function<double(double volume)>& density_of);

}  // namespace twrench::scene

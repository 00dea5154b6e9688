#pragma once

#include <functional>
#include <string>

#include "mesh/mesh_file.h"
#include "scene/scene.h"

namespace twrench::scene {

/// Returns the angular velocity in rad/s, body axes, of a motion that shows what a body does: it
/// spins at 1 rad/s about its intermediate axis, with a small push along the axis whose moment
/// differs more, so that it turns over. A body with an axis of symmetry (two moments that differ by
/// less than a ten-thousandth) spins about an axis 0.3 rad away from it, so that it wobbles. A ball
/// (three moments that differ by less than a hundredth), which would take a hundred turns for
/// either, spins about its x axis.
Eigen::Vector3d natural_omega(const body::MassProperties& body);

/// Returns the scene of a mesh alone. It is named after its file, has its natural omega and times,
/// and is seen from where its momentum lies across the picture. `density_of` returns its density in
/// g/cm^3 for its volume in cm^3. Throws as mesh::read_mesh() does, and InvalidArgument if a scene
/// file could not have that part.
Scene mesh_scene(const std::string& file, const mesh::ReadOptions& options,
                 const std::function<double(double volume)>& density_of);

}  // namespace twrench::scene

#pragma once

#include <array>
#include <functional>
#include <string>

#include "scene/scene.h"

// Scenes whose body contains a wheel or loses energy.

namespace twrench::scene {

/// The features of a film that are computed from the closed form or from the energy of a rigid
/// body.
inline constexpr std::array features_of_rigid_bodies{
    Feature::plane,   Feature::poinsot, Feature::phase,  Feature::forces,
    Feature::torques, Feature::tip,     Feature::moments};
/// The features that have a meaning only if no energy is lost: an energy that is lost is no error.
inline constexpr std::array features_of_lossless_bodies{Feature::drift};

/// Throws InvalidArgument unless the body can have the scene's wheel and energy loss, with each
/// omega of the scene. `name_of` returns the name of a key of [motion] in messages.
void check_interior(const Scene& scene,
                    const std::function<std::string(const std::string& key)>& name_of);

/// Throws InvalidArgument unless the body of the scene, without its shots, is rigid. `what` names
/// the result that needs a rigid body, such as "a check".
void require_rigid(const Scene& scene, const std::string& what);

/// Throws InvalidArgument if a scene whose body is not rigid, or such a shot, shows something in
/// its film that has a meaning only for rigid bodies, or if a film shows more than is recorded.
void check_shown_motion(const Scene& film);

}  // namespace twrench::scene

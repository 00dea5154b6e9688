#pragma once

#include <cstdint>
#include <string>

#include "cli/every_command.h"

namespace twrench {

/// A scene with only a body and a motion, of any scale.
struct RandomScene {
  /// The scene file.
  std::string toml;
  /// The body as an option, if it is given by its inertia: "--inertia A,B,C", or with six numbers
  /// if its axes are not principal axes.
  std::string inertia;
  /// "--omega=X,Y,Z".
  std::string omega;
};

/// Returns the scene with that number of a seed. Lengths are from 1e-6 to 1e6 cm, masses from 1e-6
/// to 1e6 g; a turn takes from 1e-6 to 1e6 s or, for every fourth scene, from 1e-9 to 1e9 s. The
/// body spins near the axis of its least, intermediate (twice) or greatest moment, or about any
/// direction.
RandomScene random_scene(std::uint32_t seed, std::uint32_t number);

/// Returns the scene for every command: as options if `by_options` and the scene has them,
/// otherwise as the file own.toml.
CommandSubject subject_of(const RandomScene& random, bool by_options);

}  // namespace twrench

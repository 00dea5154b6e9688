#pragma once

#include <twrench/body/mass_properties.h>

#include "scene/scene.h"

namespace twrench::python {

/// twrench.Body: how it was given, and the mass properties that follow.
struct Body {
  /// Empty if it was given by an inertia matrix, which no scene can show.
  scene::Body description;
  body::MassProperties properties;
};

/// A scene's body.
inline Body body_of(const scene::Scene& scene) {
  const body::MassProperties properties = scene::mass_properties(scene.body);
  return {scene.body, properties};
}

}  // namespace twrench::python

#pragma once

#include <twrench/body/mass_properties.h>

#include "scene/scene.h"

namespace twrench::python {

/// twrench.Body: its definition, and the resulting mass properties.
struct Body {
  scene::Body description;
  body::MassProperties properties;
};

/// A scene's body.
inline Body body_of(const scene::Scene& scene) {
  const body::MassProperties properties = scene::mass_properties(scene.body);
  return {scene.body, properties};
}

}  // namespace twrench::python

#pragma once

#include "scene/materials.h"
#include "scene/scene.h"
#include "scene_dice.h"

namespace twrench::torture {

/// Returns a body of parts, or a body given by its inertia alone. Throws InvalidArgument if it
/// would have a mesh that is not a solid.
scene::Body random_body(SceneDice& dice);

inline Color random_color(SceneDice& dice) {
  const int red = dice.whole(0, 255), green = dice.whole(0, 255);
  return {red, green, dice.whole(0, 255)};
}

/// Varies the values that are common to Look and PartLook.
void vary(SceneDice& dice, auto& look) {
  if (dice.chance(0.2)) set_material(look, dice.pick(scene::materials()));
  if (dice.chance(0.2)) look.color = random_color(dice);
  if (dice.chance(0.2)) look.metallic = dice.uniform(0, 1);
  if (dice.chance(0.2)) look.roughness = dice.uniform(0.05, 1);
}

}  // namespace twrench::torture

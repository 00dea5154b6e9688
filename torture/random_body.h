#pragma once

#include "scene/materials.h"
#include "scene/scene.h"
#include "scene_dice.h"

namespace twrench::torture {

/// A body of parts, or one of inertia alone. Throws InvalidArgument where it would have a mesh that
/// is no solid.
scene::Body random_body(SceneDice& dice);

inline Color random_color(SceneDice& dice) {
  const int red = dice.whole(0, 255), green = dice.whole(0, 255);
  return {red, green, dice.whole(0, 255)};
}

/// The values that a Look and a PartLook have in common.
void vary(SceneDice& dice, auto& look) {
  if (dice.chance(0.2)) set_material(look, dice.pick(scene::materials()));
  if (dice.chance(0.2)) look.color = random_color(dice);
  if (dice.chance(0.2)) look.metallic = dice.uniform(0, 1);
  if (dice.chance(0.2)) look.roughness = dice.uniform(0.05, 1);
}

}  // namespace twrench::torture

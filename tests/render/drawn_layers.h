#pragma once

#include <vector>

#include "render/compose/element.h"

namespace twrench::render {

/// Returns what a view draws, completed.
inline std::vector<Layer> drawn_layers(SpaceView& view, const timeline::FrameState& state) {
  std::vector<Layer> layers;
  for (PendingLayer& layer : view.draw(state)) layers.push_back(std::get<Layer>(layer.get()));
  return layers;
}

}  // namespace twrench::render

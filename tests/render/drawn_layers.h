#pragma once

#include <vector>

#include "render/compose/element.h"

namespace twrench::render {

/// Returns what an element draws, once all its pixels have arrived.
inline std::vector<Layer> drawn_layers(Element& element, const timeline::FrameState& state) {
  std::vector<Layer> layers;
  for (PendingLayer& layer : element.draw(state)) layers.push_back(std::get<Layer>(layer.get()));
  return layers;
}

}  // namespace twrench::render

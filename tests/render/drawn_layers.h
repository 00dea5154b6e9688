#pragma once

#include <vector>

#include "render/element.h"

namespace twrench {

/// Returns what an element draws, once all its pixels have arrived.
inline std::vector<Layer> drawn_layers(Element& element, const Moment& moment) {
  std::vector<Layer> layers;
  for (PendingLayer& layer : element.draw(moment)) layers.push_back(layer.get());
  return layers;
}

}  // namespace twrench

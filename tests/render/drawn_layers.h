#pragma once

#include <vector>

#include "render/element.h"

namespace twrench {

/// What an element draws, when all its pixels are there.
inline std::vector<Layer> drawn_layers(Element& element, const Moment& moment) {
  std::vector<Layer> layers;
  for (PendingLayer& layer : element.draw(moment)) layers.push_back(layer.get());
  return layers;
}

}  // namespace twrench

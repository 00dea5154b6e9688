#pragma once

#include <vector>

#include "render/layer.h"
#include "timeline/timeline.h"

namespace twrench {

/// A part of the picture: a view of the body, a panel, a line of text.
class Element {
 public:
  virtual ~Element() = default;

  /// What of it is the same in every frame; asked for once.
  virtual std::vector<Layer> still() { return {}; }

  /// What of it changes, in the order in which it is to be laid over the picture. Layers are whole
  /// inside the picture, and as small as what they show.
  virtual std::vector<Layer> draw(const Moment& moment) = 0;
};

}  // namespace twrench

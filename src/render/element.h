#pragma once

#include <vector>

#include "render/label.h"
#include "render/pending_layer.h"
#include "timeline/timeline.h"

namespace twrench {

/// A part of the picture: a view of the body, a panel, a line of text.
class Element {
 public:
  virtual ~Element() = default;

  /// What of it is the same in every frame; asked for once.
  virtual std::vector<Layer> still() { return {}; }

  /// What of it changes, in the order in which it is to be laid over the picture. Layers are whole
  /// inside the picture, and as small as what they show. Others may be drawn before they are asked
  /// for; the element outlives them.
  virtual std::vector<PendingLayer> draw(const Moment& moment) = 0;

  /// The names of things in it, that are to be written over all elements.
  virtual std::vector<Label> labels(const Moment& /*moment*/) const { return {}; }
};

/// One that shows things in space.
class SpaceView : public Element {
 public:
  /// `film_time` in s: the camera may move.
  virtual Camera camera(double film_time) const = 0;
};

}  // namespace twrench

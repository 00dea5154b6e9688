#include "picture/views/view.h"

namespace twrench::picture {

void ViewContents::begin(const Camera& camera_in_space, const image::Area& pane, bool moves) {
  camera = camera_in_space;
  is_moving = moves;
  X.reset();
  blur.clear();
  opaque.begin(camera, pane);
  translucent.begin(camera, pane);
  labels.clear();
}

Framing seen_from(Framing framing, const Viewpoint& from) {
  framing.direction = direction_of(from.azimuth, from.elevation);
  framing.distance /= from.zoom;
  framing.centre *= from.zoom;
  return framing;
}

}  // namespace twrench::picture

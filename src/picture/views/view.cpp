#include "picture/views/view.h"

namespace twrench::picture {

void ViewContents::begin(const Camera& camera_in_space, const image::Area& pane) {
  camera = camera_in_space;
  X.reset();
  blur.clear();
  opaque.begin(camera, pane);
  translucent.begin(camera, pane);
  labels.clear();
}

}  // namespace twrench::picture

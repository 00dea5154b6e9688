#pragma once

#include "picture/views/view.h"

namespace twrench::picture {

/// Returns what a view shows in a frame, through its own camera.
inline ViewContents shown_by(const View& view, const timeline::FrameState& state) {
  ViewContents contents;
  contents.begin(view.camera_in_space(state), view.pane().area);
  view.add(state, contents);
  return contents;
}

}  // namespace twrench::picture

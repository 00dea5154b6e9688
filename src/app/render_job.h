#pragma once

#include "app/render_options.h"

namespace twrench::app {

/// Draws the frames that the options ask for, and writes them and the video. Throws as the stages
/// do; what cannot work fails before the first frame.
void render_film(const RenderOptions& options);

}  // namespace twrench::app

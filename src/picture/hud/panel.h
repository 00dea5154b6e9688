#pragma once

#include "canvas/canvas.h"
#include "picture/look/theme.h"

namespace twrench::picture {

/// Draws the background of a panel: a rectangle with rounded corners of at most that radius in px.
void draw_panel(canvas::Canvas& canvas, const image::Area& area, double radius,
                const OverlayColors& colors);

/// Returns the part of a panel inside its padding; `size` is that of its text, in px per em.
image::Area panel_content(const image::Area& panel, double size);

}  // namespace twrench::picture

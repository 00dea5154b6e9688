#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace twrench::page {

/// A picture that a view of the page shows until it can draw.
struct Still {
  /// The name by which its views find it: the attribute data-still of their elements.
  std::string name;
  /// The scenes of its panes at t = 0, side by side. Those of one still have the same size;
  /// together they have the size of every other still. The momentum sphere beside a body is the
  /// last pane.
  std::vector<scene::Scene> panes;
};

/// Returns the stills of a page: of the figures of the article, if the page has it, and of the
/// insets of the lab. The body in the lab has the poster.
std::vector<Still> stills_of(const scene::Scene& shown, bool has_article);

}  // namespace twrench::page

#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "picture/views/solution_view.h"
#include "scene/phrase.h"

namespace twrench::picture {

/// A view of scene::insets.
struct InsetView {
  scene::View view;
  /// A line that names the contents.
  scene::Phrase heading;
  /// Returns sentences that describe the contents for this motion.
  std::string (*description)(const timeline::Solution& solution, const PrincipalFrame& frame,
                             scene::Language language);
  /// Creates the view, which shows the first motion in `pane`.
  std::unique_ptr<SolutionView> (*make)(const scene::Scene& scene,
                                        const std::vector<timeline::Solution>& solutions,
                                        const Layout::Pane& pane);
};

/// The views of scene::insets, in their order.
extern const std::array<InsetView, scene::insets.size()> inset_views;

}  // namespace twrench::picture

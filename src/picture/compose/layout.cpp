#include "picture/compose/layout.h"

#include <twrench/base/error.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "base/enumeration.h"
#include "picture/compose/layout_draft.h"

namespace twrench::picture {
namespace {

Parts parts_of(const scene::Overlay& overlay) {
  const bool single = overlay.motion_count() == 1;
  const bool shows_body = overlay.view == scene::View::wrench;
  Parts parts{};
  for (std::size_t i = 0; i < scene::insets.size(); ++i) {
    parts[first_view + i] = single && shows_body && overlay.shows(scene::insets[i].feature);
  }
  parts[components_part] = shows_body && overlay.shows(scene::Feature::components);
  parts[curve_part] = shows_body && overlay.shows(scene::Feature::curve);
  const bool hud = overlay.shows(scene::Feature::hud);
  const bool method = overlay.shows(scene::Feature::method);
  parts[title_part] = hud || (single && method);
  parts[readouts_part] = hud || overlay.shows(scene::Feature::drift) || (!single && method);
  return parts;
}

void require_sphere_of_phase(const scene::Overlay& overlay) {
  const bool has_sphere =
      overlay.view == scene::View::momentum || overlay.view == scene::View::quad ||
      (overlay.view == scene::View::wrench && overlay.shows(scene::Feature::sphere));
  if (has_sphere || !overlay.shows(scene::Feature::phase)) return;
  throw InvalidArgument("show", "phase is an area on the momentum sphere, which is not shown",
                        "show sphere too, or use the view 'momentum' or 'quad'");
}

void require_rotating_frame(const scene::Scene& scene) {
  if (scene.camera.frame == scene::Frame::rotating) return;
  for (const scene::Feature feature : {scene::Feature::torques, scene::Feature::tip}) {
    if (!scene.overlay.shows(feature)) continue;
    const std::string name(enumerator_name(feature)), frame(enumerator_name(scene.camera.frame));
    throw InvalidArgument(
        "show", name + " shows the forces in the frame 'rotating'; the frame is '" + frame + "'",
        "use the frame 'rotating'");
  }
}

}  // namespace

double readouts_height(const Layout::TextSizes& sizes, bool compact, int rows) {
  const double row =
      readout_height * sizes.readout + (compact ? 0 : caption_height * sizes.caption);
  return rows * row + (rows - 1) * readout_row_gap * sizes.readout;
}

bool is_strip(const image::Area& components) {
  return components.height < least_square && components.width > 4 * components.height;
}

Layout compute_layout(const scene::Scene& scene) {
  const scene::Overlay& overlay = scene.overlay;
  const std::array<std::pair<const char*, bool>, 3> comparisons{
      {{"compare_omega", !overlay.compare_omega.empty()},
       {"compare_wheel", !overlay.compare_wheel.empty()},
       {"compare", !overlay.compare.empty()}}};
  std::vector<std::string> compared;
  for (const auto& [key, is_given] : comparisons) {
    if (is_given) compared.emplace_back(key);
  }
  if (compared.size() > 1) {
    throw InvalidArgument(compared[0], "cannot be combined with " + compared[1],
                          "compare methods, initial angular velocities or wheels");
  }
  if (overlay.motion_count() > 1 && overlay.view != scene::View::wrench) {
    throw InvalidArgument(
        compared[0],
        "the view '" + std::string(enumerator_name(overlay.view)) + "' shows only one motion",
        "use the view 'wrench' to compare motions");
  }
  require_sphere_of_phase(overlay);
  require_rotating_frame(scene);
  Parts parts = parts_of(scene.overlay);
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
    for (const TextPlacement placement : {TextPlacement::with_insets, TextPlacement::with_body}) {
      if (auto layout = LayoutDraft(scene, parts, placement).finish()) return *layout;
    }
    *part = false;
  }
  return *LayoutDraft(scene, parts, TextPlacement::with_body).finish();
}

}  // namespace twrench::picture

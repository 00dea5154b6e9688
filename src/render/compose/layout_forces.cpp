#include "render/compose/layout_forces.h"

#include <algorithm>
#include <cmath>

#include "render/compose/cut.h"

namespace twrench::render {
namespace {

constexpr double legend_height = 1.25, least_legend = 20;     // em of a readout
constexpr double least_panel_width = 12, least_height = 6.5;  // em of a caption
constexpr int least_share = 3;                                // of the pane is the focus: a third
constexpr std::size_t most_groups = 4;                        // of parts
constexpr int least_over_torques = 4;                         // heights of their row
constexpr double panel_share = 0.3;                           // of the focus
constexpr double moments_share = 0.48;                        // of an area that holds both

int shorter_side(const image::Area& area) { return std::min(area.width, area.height); }

bool holds_panel(const image::Area& area, double size) {
  return area.width >= least_panel_width * size && area.height >= least_height * size;
}

/// Whether there are torques of forces to compare, of few enough groups of parts.
bool compares_torques(const scene::Scene& scene) {
  const std::size_t groups = scene::part_groups(scene.body).size();
  return scene.overlay.shows(scene::Feature::forces) && scene.camera.frame != scene::Frame::space &&
         groups >= 2 && groups <= most_groups;
}

/// The placing of what is added to a layout of one body.
class Addition {
 public:
  Addition(Layout& layout, const scene::Scene& scene)
      : layout_(layout),
        overlay_(scene.overlay),
        compares_torques_(compares_torques(scene)),
        pane_(layout.panes[0].area),
        gap_(std::max(4, std::min(scene.film.width, scene.film.height) / 40)) {
    const int x = static_cast<int>(std::ceil(0.05 * scene.film.width));
    const int y = static_cast<int>(std::ceil(0.05 * scene.film.height));
    focus_ = image::common(layout.panes[0].focus,
                           {x, y, scene.film.width - 2 * x, scene.film.height - 2 * y});
  }

  void place_panels();
  void place_legend();

 private:
  /// Takes the rest of a focus from which something was cut, if the body keeps a third of its pane.
  bool take(const image::Area& rest) {
    if (least_share * shorter_side(rest) < shorter_side(pane_)) return false;
    layout_.panes[0].focus = focus_ = rest;
    return true;
  }
  int torques_height() const {
    return static_cast<int>(std::lround(readouts_height(layout_.text, layout_.compact, 1)));
  }
  image::Area cut_panels(image::Area& rest) const;
  image::Area beside_focus(image::Area area) const;

  Layout& layout_;
  const scene::Overlay& overlay_;
  bool compares_torques_;
  image::Area pane_;
  int gap_;
  image::Area focus_;  ///< Within the title-safe area.
};

/// Cuts a part of the focus: from its right or, of an upright one, from its bottom.
image::Area Addition::cut_panels(image::Area& rest) const {
  if (rest.height > rest.width) {
    return cut_bottom(rest, static_cast<int>(panel_share * rest.height), gap_);
  }
  return cut_right(rest, static_cast<int>(panel_share * rest.width), gap_);
}

/// Returns the area extended to the height of the focus, as far as text leaves room, if it stands
/// beside that alone.
image::Area Addition::beside_focus(image::Area area) const {
  const bool alone =
      !layout_.momentum && !layout_.poinsot && !(layout_.curve && layout_.components);
  if (!alone || area.x < focus_.x + focus_.width) return area;
  int top = focus_.y, bottom = focus_.y + focus_.height;
  for (const auto& text : {layout_.title, layout_.readouts}) {
    if (!text || text->x >= area.x + area.width || text->x + text->width <= area.x) continue;
    if (text->y < area.y) top = std::max(top, text->y + text->height + gap_);
    if (text->y > area.y) bottom = std::min(bottom, text->y - gap_);
  }
  bottom = std::max(bottom, area.y + area.height);
  top = std::min(top, area.y);
  return {area.x, top, area.width, bottom - top};
}

/// Divides the area of the curve or the components, or a part of the focus, among tilt, moments and
/// torques.
void Addition::place_panels() {
  const bool tilt = overlay_.shows(scene::Feature::tilt);
  const bool moments = overlay_.shows(scene::Feature::moments);
  if (!tilt && !moments) return;
  image::Area rest = focus_;
  std::optional<image::Area>& plot = layout_.curve ? layout_.curve : layout_.components;
  image::Area area = plot ? beside_focus(*plot) : cut_panels(rest);
  const double size = layout_.text.caption;
  if (!holds_panel(area, size) || (!plot && !take(rest))) return;
  plot.reset();
  const int row = torques_height();
  if (compares_torques_ && area.height > least_over_torques * row) {
    layout_.torques = cut_bottom(area, row, gap_);
  }
  if (tilt && moments) {
    image::Area left = area;
    const bool beside = area.width > 1.6 * area.height;
    const image::Area first =
        beside ? cut_left(left, static_cast<int>(moments_share * area.width), gap_)
               : cut_top(left, static_cast<int>(moments_share * area.height), gap_);
    if (holds_panel(first, size) && holds_panel(left, size)) {
      layout_.moments = first;
      area = left;
    }
  }
  (tilt ? layout_.tilt : layout_.moments) = area;
}

/// Places the legend and, unless they stand among the panels, the torques above it.
void Addition::place_legend() {
  const double size = layout_.text.readout;
  if (!overlay_.shows(scene::Feature::forces) || focus_.width < least_legend * size) return;
  image::Area rest = focus_;
  const image::Area row =
      cut_bottom(rest, static_cast<int>(std::lround(legend_height * size)), gap_);
  if (rest.height <= 0 || !take(rest)) return;
  layout_.forces = row;
  if (!compares_torques_ || layout_.torques) return;
  const image::Area torques = cut_bottom(rest, torques_height(), gap_);
  if (rest.height > 0 && take(rest)) layout_.torques = torques;
}

}  // namespace

Layout with_forces(Layout layout, const scene::Scene& scene) {
  if (scene.overlay.view != scene::View::wrench || layout.panes.size() != 1) return layout;
  Addition addition(layout, scene);
  addition.place_panels();
  addition.place_legend();
  return layout;
}

}  // namespace twrench::render

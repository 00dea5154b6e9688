#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "image/area.h"
#include "scene/scene.h"

namespace twrench::picture {

/// The layout of the picture. Text and insets stay 5 % of the picture's sides away from its edges,
/// and overlap neither each other nor the focus of any pane. The insets are in a column beside the
/// body, with the title above them and the readouts below. In an upright picture they are in a
/// block below the body. In a picture more than three times as long as it is wide, all items are in
/// one line, so that each has the full breadth.
///
/// Items that do not fit are dropped in this order, until the rest has its minimum size and each
/// body a third of its pane: the views of scene::insets, the last first, the components, the large
/// curve, the readouts, the title.
struct Layout {
  /// A three-dimensional view.
  struct Pane {
    image::Area area;   ///< The entire pane.
    image::Area focus;  ///< The part in which the body is framed, free of other items.
    bool named = true;  ///< Whether there is room for labels.
    /// A line that names the contents of an inset.
    std::optional<image::Area> heading = std::nullopt;
    /// Width in pixels of the thinnest line that is drawn.
    double thinnest = 1;
  };

  /// Text sizes in px per em.
  struct TextSizes {
    /// The title.
    double title;
    /// Values of readouts.
    double readout;
    /// Captions of readouts and plots.
    double caption;
  };

  /// The caption of a shot, in a band at the bottom that nothing else enters.
  struct Caption {
    static constexpr double line_height = 1.3;  ///< em

    image::Area area;  ///< High enough for `most_lines`.
    double size;       ///< px per em; capitals are a 25th of the shorter side high.
    int most_lines;

    /// Returns the width in em of the longest line: longer ones are hard to read.
    double line_width() const { return std::min(area.width / size, 26.0); }
  };

  /// Panes of the body, one per motion. They tile the picture or, in the view `quad`, a quarter of
  /// it. Empty if the view shows no body.
  std::vector<Pane> panes;
  /// The views of scene::insets, in their order.
  std::array<std::optional<Pane>, scene::insets.size()> insets;
  /// The nine components, and the one that shows whether the body turns over, large.
  std::optional<image::Area> components, curve;
  /// In a comparison of methods, the angles between the motions, beside the curve.
  std::optional<image::Area> angle;
  /// The title, with the method below it or, in a comparison, the time on the right.
  std::optional<image::Area> title;
  /// The sentences that describe a view without the body.
  std::optional<image::Area> description;
  /// The remark on what happens, and the readouts of a single motion.
  std::optional<image::Area> readouts;
  /// The legend of the forces, in one row below the bodies, and the gauge of the torques of a
  /// single body above it.
  std::optional<image::Area> forces, torques;
  /// The tilt against time and the principal moments. They replace the curve or the components or,
  /// if neither is shown, take a part of the body's pane.
  std::optional<image::Area> tilt, moments;
  /// In a comparison, the method, readouts and remark of each pane.
  std::vector<image::Area> legends;

  /// The caption; nothing in a film without captions, and in a picture too small for them.
  std::optional<Caption> caption;

  /// Text sizes.
  TextSizes text{};
  /// Whether the picture is too small for captions above the readouts, and for remarks.
  bool compact = false;
};

/// Heights of the caption above a readout, in em of the caption; and of the readout's value, of the
/// gap between two rows of readouts, and of a remark, in em of the value.
inline constexpr double caption_height = 1.4;
inline constexpr double readout_height = 1.25;
inline constexpr double readout_row_gap = 0.35;
inline constexpr double remark_height = 1.6;

/// Returns the height in px of that many rows of readouts with captions.
double readouts_height(const Layout::TextSizes& sizes, bool compact, int rows);

/// Returns the size in px per em of the text of the torques: its digits are a 50th of the picture's
/// shorter side high.
inline double torque_text_size(const Layout::TextSizes& sizes) { return 1.1 * sizes.readout; }

/// Returns whether the nine components are in one row, instead of three rows of three.
bool is_strip(const image::Area& components);

/// Computes the layout. Throws InvalidArgument for a phase without its sphere, for torques or the
/// tip in a frame other than the rotating one, and for a comparison in a view that shows only one
/// motion.
Layout compute_layout(const scene::Scene& scene);

}  // namespace twrench::picture

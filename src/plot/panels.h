#pragma once

#include <string>
#include <string_view>

#include "base/time_unit.h"
#include "scene/scene.h"

namespace twrench::plot {

/// Panels of equal size in rows and columns, with margins in pixels.
struct PanelGrid {
  /// Size of the plot in pixels.
  int width, height;
  /// Number of panels.
  int rows, columns;
  /// Margins beside the outermost panels in pixels.
  int left, right, bottom, top;
  /// Gaps between panels in pixels.
  int between_columns, between_rows;

  /// Return the size of a panel in pixels.
  double panel_width() const {
    return double(width - left - right - (columns - 1) * between_columns) / columns;
  }
  double panel_height() const {
    return double(height - top - bottom - (rows - 1) * between_rows) / rows;
  }

  /// Returns the commands that place the next plot in that panel. Row 0 is at the top.
  std::string place(int row, int column) const;
};

/// The commands at the beginning of all diagrams: faint frame and grid, no key.
inline constexpr std::string_view diagram_style =
    "set border lw 0.6 lc rgb '#808080'\n"
    "set tics nomirror scale 0.5 textcolor rgb '#404040'\n"
    "set grid lc rgb '#e4e4e4' lt 1 lw 0.6\n"
    "set key off\n";

/// Returns the label of a time axis, as "t (s)".
std::string time_label(const TimeUnit& unit, scene::Language language);

/// Returns a key across the full width, which must be the last plot: `entries`, each ", keyentry
/// ...", in at most the given number of columns, centred at `height` (0 to 1) above the lower edge.
std::string key_plot(const std::string& entries, int columns, double height);

}  // namespace twrench::plot

#pragma once

#include <string>
#include <string_view>

namespace twrench {

/// Panels of equal size in rows and columns, and the room around them, in pixels.
struct PanelGrid {
  int width, height;  ///< of the figure
  int rows, columns;
  int left, right, bottom, top;  ///< room beside the outermost panels
  int between_columns, between_rows;

  /// The commands that put the next plot there. Row 0 is at the top.
  std::string place(int row, int column) const;
};

/// The commands that all our diagrams begin with: faint frame and grid, no key.
inline constexpr std::string_view diagram_style =
    "set border lw 0.6 lc rgb '#808080'\n"
    "set tics nomirror scale 0.5 textcolor rgb '#404040'\n"
    "set grid lc rgb '#e4e4e4' lt 1 lw 0.6\n"
    "set key off\n";

/// A key over the whole width of the figure, to be the last plot: `entries`, each ", keyentry ...",
/// in so many columns at most, its middle `height` (0 to 1) above the lower edge.
std::string key_plot(const std::string& entries, int columns, double height);

}  // namespace twrench

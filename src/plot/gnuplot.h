#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/time_unit.h"
#include "scene/scene.h"
#include "system/error.h"
#include "system/output.h"
#include "system/pending_file.h"

namespace twrench::plot {

/// gnuplot is missing, lacks the format, or failed.
struct PlotError : Error {
  using Error::Error;
};

/// A plot for gnuplot: its size in pixels of 1/96 inch, and the commands after those that set the
/// format.
struct Plot {
  /// Size in pixels of 1/96 inch.
  int width, height;
  /// gnuplot commands.
  std::string script;
};

/// Colours of curves on white, one for each method. They have a contrast of at least 3 (WCAG 2.1,
/// 1.4.11); any two differ by 38 (CIE Lab), and by 17 for protan, deutan and tritan vision (Machado
/// et al. 2009). Except for black, none is so dark that a thin line in it looks black.
inline constexpr std::array<std::string_view, 13> palette{
    "#089DDD", "#B6310C", "#157A42", "#C247A6", "#C17B01", "#5267CC", "#000000",
    "#FC2578", "#759086", "#C001FF", "#692C36", "#33496C", "#421CBC"};

/// Returns the text as a quoted gnuplot string that reproduces it exactly.
std::string gnuplot_string(std::string_view text);

/// Checks that gnuplot can write a format of system::plot_output; call it before any work. Throws
/// PlotError if gnuplot is missing or cannot write it.
void require_gnuplot(const system::OutputFormat& format);

/// Adds the plot that a command draws beside its output to its files, and checks that gnuplot can
/// write it. Nothing for an empty path. Throws as FileList::add_output() and require_gnuplot() do.
std::optional<system::OutputFile> add_plot(system::FileList& files, const std::string& path);

/// Returns the plot as the text of an SVG file. Throws PlotError if gnuplot is missing or fails,
/// and FileError if gnuplot left the plot incomplete.
std::string svg(const Plot& plot);

/// Draws the plot into a file, one of system::plot_output, that appears when it is committed.
/// Throws as draw_plot() does.
std::unique_ptr<system::PendingFile> draw_pending_plot(const system::OutputFile& file,
                                                       const Plot& plot);

/// Draws the plot into the file, one of system::plot_output, which appears complete or not at all.
/// Throws PlotError if gnuplot is missing or fails, and FileError.
void draw_plot(const system::OutputFile& file, const Plot& plot);

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

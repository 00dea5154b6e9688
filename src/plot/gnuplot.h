#pragma once

#include <array>
#include <string>
#include <string_view>

#include "system/error.h"

namespace twrench::plot {

/// gnuplot is missing, lacks the format, or failed.
struct PlotError : Error {
  using Error::Error;
};

/// A plot as gnuplot draws it: its size in pixels of 1/96 inch, and the commands that follow the
/// choice of the format.
struct Plot {
  /// Size in pixels of 1/96 inch.
  int width, height;
  /// gnuplot commands.
  std::string script;
};

/// The colours of Okabe and Ito, which are distinguishable with colour vision deficiency, without
/// the yellow, which is too pale for lines on white.
inline constexpr std::array<std::string_view, 7> palette{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                         "#E69F00", "#56B4E9", "#000000"};

/// Returns the text as a quoted gnuplot string that reproduces it exactly.
std::string gnuplot_string(std::string_view text);

/// Checks that gnuplot can write the file; call it before any work. Throws InvalidArgument if the
/// path does not end in .svg, .pdf or .png, PlotError if gnuplot is missing or cannot write that
/// format.
void require_gnuplot(const std::string& path);

/// Draws the plot into the file, in the format of its ending; the file appears complete or not at
/// all. Throws as require_gnuplot() does, PlotError if gnuplot fails, and FileError.
void draw_plot(const std::string& path, const Plot& plot);

}  // namespace twrench::plot

#pragma once

#include <array>
#include <string>
#include <string_view>

#include "base/error.h"

namespace twrench {

/// gnuplot is missing, lacks the format, or failed.
struct FigureError : Error {
  using Error::Error;
};

/// A figure as gnuplot draws it: its size, in pixels of 1/96 inch, and the commands below those
/// that choose the format.
struct Figure {
  int width, height;
  std::string script;
};

/// Okabe's and Ito's colours, which colour-blind readers tell apart; without the yellow, too pale
/// for a line on white.
inline constexpr std::array<std::string_view, 7> palette{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                         "#E69F00", "#56B4E9", "#000000"};

/// The text between quotes, as gnuplot reads it back whatever is in it.
std::string gnuplot_string(std::string_view text);

/// To be called before anything runs. Throws UsageError when the path does not end in .svg, .pdf
/// or .png, FigureError when gnuplot is missing or cannot make that format.
void require_gnuplot(const std::string& path);

/// Draws the figure into the file, in the format of its ending; the file appears whole or not at
/// all. Throws as require_gnuplot; FigureError when gnuplot failed; FileError.
void draw_figure(const std::string& path, const Figure& figure);

}  // namespace twrench

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/time_unit.h"
#include "plot/gnuplot.h"
#include "plot/plots.h"
#include "scene/phrase.h"

namespace twrench::plot {
namespace {

/// The end of the time axis in s.
double end_of(std::span<const AttitudeCurve> curves) {
  double end = 0.0;
  for (const AttitudeCurve& c : curves) end = std::max(end, c.samples.back().t);
  return end;
}

/// The data blocks $c0, $c1, ...: lines of t in that unit and the nine components, row by row.
std::string data(std::span<const AttitudeCurve> curves, const TimeUnit& unit) {
  std::string text;
  const auto out = std::back_inserter(text);
  for (std::size_t c = 0; c < curves.size(); ++c) {
    fmt::format_to(out, "$c{} << END\n", c);
    for (const motion::Sample& s : curves[c].samples) {
      fmt::format_to(out, "{:.7g}", s.t / unit.length);
      for (int i = 0; i < 9; ++i) fmt::format_to(out, " {:.6f}", s.X(i / 3, i % 3));
      text += '\n';
    }
    text += "END\n";
  }
  return text;
}

std::string_view color_of(std::size_t curve) { return palette[curve % palette.size()]; }

/// Vertical lines at the flips.
std::string flip_lines(const AttitudeCurve& curve, const TimeUnit& unit, std::string_view color) {
  std::string text;
  for (const double t : curve.flips) {
    text += fmt::format(
        "set arrow from first {0:.7g}, graph 0 to first {0:.7g}, graph 1 nohead back dt (6,4) "
        "lw 1.2 lc rgb '{1}'\n",
        t / unit.length, color);
  }
  return text;
}

constexpr std::string_view single_flip_color = "#606060";

PanelGrid grid(const Plot& plot, int rows) {
  return {plot.width, plot.height, rows, 3, 66, 18, 56, 76, 36, 40};
}

std::string key_of(const Plot& plot, const std::string& entries) {
  return key_plot(entries, 6, 1.0 - 24.0 / plot.height);
}

/// The style of the line of a curve.
std::string line(std::string_view color, bool is_dashed = false) {
  return fmt::format("lines {}lw 1.6 lc rgb '{}'", is_dashed ? "dt (10,10) " : "", color);
}

std::string line_key(const std::string& line, const std::string& title) {
  return fmt::format(", keyentry with {} title {} noenhanced", line, gnuplot_string(title));
}

std::string flip_key(std::string_view color, const std::string& title) {
  return fmt::format(", keyentry with lines dt (6,4) lw 1.2 lc rgb '{}' title {} noenhanced", color,
                     gnuplot_string(title));
}

std::string ranges(double end, const TimeUnit& unit) {
  return fmt::format("set xrange [0:{:.7g}]\nset yrange [-1.12:1.12]\nset ytics -1, 1\n",
                     end / unit.length);
}

/// Labels the y axis in the first column of panels, the time axis in the last row.
std::string outer_axes(int column, bool last_row, const TimeUnit& unit, scene::Language language) {
  return fmt::format("set format y '{}'\nset format x '{}'\n{} xlabel {}\n",
                     column == 0 ? "%g" : "", last_row ? "%g" : "", last_row ? "set" : "unset",
                     last_row ? fmt::format("'{}' offset 0, 0.3", time_label(unit, language)) : "");
}

/// Plots one component of X, `column` of the data, for all curves.
std::string plot_component(std::span<const AttitudeCurve> curves, int column) {
  std::string plot;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    plot += fmt::format("{}$c{} using 1:{} with {} notitle", c == 0 ? "plot " : ", ", c, column,
                        line(color_of(c), curves[c].is_dashed));
  }
  return plot + "\n";
}

/// Plots one column of X of one motion.
std::string plot_column(std::size_t curve, int column) {
  std::string plot;
  for (std::size_t row = 0; row < 3; ++row) {
    plot += fmt::format("{}$c{} using 1:{} with {} notitle", row == 0 ? "plot " : ", ", curve,
                        2 + 3 * static_cast<int>(row) + column, line(palette[row]));
  }
  return plot + "\n";
}

}  // namespace

Plot nine_panels(std::span<const AttitudeCurve> curves, scene::Language language) {
  const double end = end_of(curves);
  const TimeUnit unit = time_unit(end);
  // With one motion the key is short. The plot is then smaller, so that its letters are larger in a
  // text.
  const bool single = curves.size() == 1;
  Plot plot{single ? 900 : 1200, single ? 740 : 820, data(curves, unit)};
  std::string& script = plot.script;
  script.append(diagram_style).append(ranges(end, unit)).append("set multiplot\n");
  std::string keys;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const std::string_view flip_color = single ? single_flip_color : color_of(c);
    script += flip_lines(curves[c], unit, flip_color);
    keys += line_key(line(color_of(c), curves[c].is_dashed), curves[c].title);
    if (!curves[c].flips.empty()) {
      keys += flip_key(flip_color, single ? scene::Phrase("flips", "vendinger").in(language)
                                          : "flips of " + curves[c].title);
    }
  }
  for (int i = 0; i < 9; ++i) {
    const int row = i / 3, column = i % 3;
    script += grid(plot, 3).place(row, column) + outer_axes(column, row == 2, unit, language);
    script += fmt::format("set title 'x_{{{}{}}}' offset 0, -0.7\n", row + 1, column + 1);
    script += plot_component(curves, 2 + i);
  }
  script += key_of(plot, keys) + "unset multiplot\n";
  return plot;
}

Plot column_panels(std::span<const AttitudeCurve> curves) {
  const auto rows = static_cast<int>(curves.size());
  const double end = end_of(curves);
  const TimeUnit unit = time_unit(end);
  Plot plot{1200, 140 + 240 * rows, data(curves, unit)};
  std::string& script = plot.script;
  script.append(diagram_style).append(ranges(end, unit)).append("set multiplot\n");
  bool flips = false;
  for (int row = 0; row < rows; ++row) {
    const auto c = static_cast<std::size_t>(row);
    flips = flips || !curves[c].flips.empty();
    script += "unset arrow\n" + flip_lines(curves[c], unit, single_flip_color);
    script +=
        fmt::format("set ylabel {} noenhanced offset 1.2, 0\n", gnuplot_string(curves[c].title));
    for (int column = 0; column < 3; ++column) {
      script += grid(plot, rows).place(row, column) +
                outer_axes(column, row == rows - 1, unit, scene::Language::en);
      script += fmt::format(
          "set title '{{/:Bold "
          "{0}}}_{{b}}\u00a0=\u00a0(x_{{1{1}}},\u00a0x_{{2{1}}},\u00a0x_{{3{1}}})' "
          "offset 0, -0.7\n",
          // No-break spaces, because SVG drops other spaces next to a subscript.
          "ijk"[column], column + 1);
      script += plot_column(c, column) + "unset ylabel\n";
    }
  }
  std::string keys;
  for (std::size_t i = 0; i < 3; ++i)
    keys += line_key(line(palette[i]), fmt::format("{} in space", "xyz"[i]));
  script += key_of(plot, flips ? keys + flip_key(single_flip_color, "flips") : keys);
  script += "unset multiplot\n";
  return plot;
}

}  // namespace twrench::plot

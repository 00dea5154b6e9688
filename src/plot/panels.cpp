#include "plot/panels.h"

#include <fmt/format.h>

namespace twrench::plot {

std::string PanelGrid::place(int row, int column) const {
  const double w = panel_width(), h = panel_height();
  const double x = left + column * (w + between_columns);
  const double y = bottom + (rows - 1 - row) * (h + between_rows);
  return fmt::format(
      "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n"
      "set bmargin at screen {:.5f}\nset tmargin at screen {:.5f}\n",
      x / width, (x + w) / width, y / height, (y + h) / height);
}

std::string time_label(const TimeUnit& unit, scene::Language language) {
  // The names of units are English, the symbols international.
  return fmt::format("t ({})", language == scene::Language::en ? unit.name : unit.symbol);
}

std::string key_plot(const std::string& entries, int columns, double height) {
  return fmt::format(
      "unset border\nunset tics\nunset grid\nunset title\nunset xlabel\nunset ylabel\n"
      "unset arrow\nunset label\nunset logscale\n"
      "set lmargin at screen 0.01\nset rmargin at screen 0.99\n"
      "set bmargin at screen 0.01\nset tmargin at screen 0.99\n"
      "set xrange [0:1]\nset yrange [0:1]\n"
      "set key on at screen 0.5, screen {:.5f} center center horizontal maxcols {} samplen 3 "
      "width 2 Left reverse\n"
      "plot -1 notitle{}\n",
      height, columns, entries);
}

}  // namespace twrench::plot

#include "plot/gnuplot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "system/descriptor.h"
#include "system/program.h"

namespace twrench::plot {
namespace {

using namespace std::string_view_literals;

/// An output format of gnuplot. A file gets the mark of system::plot_output, at a place where
/// readers ignore it.
struct Format {
  std::string_view name;
  std::string_view terminal;
  std::string_view last_bytes;  ///< the end of a complete file, ignoring white space
  std::string_view mark;
  std::size_t (*place_of_mark)(std::string_view file);
};

/// After the signature and the header of a PNG file.
constexpr std::size_t first_png_chunk = 33;

constexpr std::array<Format, 3> formats{
    {{"svg", "svg", "</svg>", "<!-- twrench -->\n",
      [](std::string_view file) { return file.size(); }},
     {"pdf", "pdfcairo", "%%EOF", "%twrench\n",
      [](std::string_view file) { return file.rfind("startxref"); }},
     {"png", "pngcairo", "IEND\xae\x42\x60\x82",
      "\0\0\0\x10tEXtSoftware\0twrench\x7b\x14\xf3\xe5"sv,
      [](std::string_view) { return first_png_chunk; }}}};

const Format& gnuplot_format(const system::OutputFormat& format) {
  return *std::ranges::find(formats, format.name, &Format::name);
}

/// gnuplot without the user's ~/.gnuplot and environment settings, so that plots are reproducible.
std::vector<std::string> command_of(const std::vector<std::string>& arguments) {
  std::vector<std::string> command{"gnuplot", "--default-settings"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return command;
}

system::ChildProcess start(const std::vector<std::string>& arguments,
                           int output = system::ChildProcess::output_dropped) {
  return system::start_program<PlotError>(command_of(arguments),
                                          "install it: apt-get install gnuplot-nox", {}, output);
}

/// The plot has the same size in all formats, each in its own units; PNG has twice the resolution.
std::string terminal(const Format& format, const Plot& plot) {
  const std::string start =
      fmt::format("set encoding utf8\nset terminal {} enhanced size ", format.terminal);
  if (format.name == "svg") {
    return start + fmt::format("{},{} font 'DejaVu Sans,13' background '#ffffff'\n", plot.width,
                               plot.height);
  }
  if (format.name == "pdf") {
    return start + fmt::format("{:.4f}in,{:.4f}in font 'DejaVu Sans,8' fontscale 1\n",
                               plot.width / 96.0, plot.height / 96.0);
  }
  return start + fmt::format(
                     "{},{} font 'DejaVu Sans,10.5' fontscale 2 linewidth 2 pointscale 2 "
                     "background '#ffffff'\n",
                     2 * plot.width, 2 * plot.height);
}

/// Feeds the plot to gnuplot, which writes to the descriptor; messages call the plot `name`.
void draw(int output, const Format& format, const Plot& plot, const std::string& name) {
  const std::string script = terminal(format, plot) + plot.script + "\nunset output\n";
  system::ChildProcess gnuplot = start({}, output);
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(script.data());
  gnuplot.write({bytes, script.size()});
  if (const int status = gnuplot.wait(); status != 0) {
    throw PlotError("cannot draw " + name, system::failure_of("gnuplot", gnuplot, status));
  }
}

/// gnuplot does not check its own writes.
void require_complete(std::string_view text, const Format& format, const std::string& name) {
  while (text.ends_with('\n')) text.remove_suffix(1);
  if (text.ends_with(format.last_bytes)) return;
  throw system::FileError("cannot write " + name, "gnuplot left it incomplete",
                          "check whether the disk is full");
}

/// Draws the whole file in memory.
std::string drawn(const Format& format, const Plot& plot, const std::string& name) {
  const system::MemoryFile file("");
  draw(file.descriptor(), format, plot, name);
  std::string text = file.contents();
  require_complete(text, format, name);
  return text;
}

}  // namespace

std::string gnuplot_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = byte >= 0x20 && byte != '"' && byte != '\\' && byte != '`';
    result += plain ? std::string(1, c) : fmt::format("\\{:03o}", byte);
  }
  return result + '"';
}

void require_gnuplot(const system::OutputFormat& format) {
  const std::string_view terminal = gnuplot_format(format).terminal;
  const std::vector<std::string> test{"-e", fmt::format("set terminal {}", terminal)};
  system::ChildProcess gnuplot = start(test);
  const int status = gnuplot.wait();
  if (status == 0) return;
  constexpr int signals = 128;  // a status above it means that a signal ended the program
  throw PlotError(fmt::format("gnuplot cannot write {} files", format.endings[0]),
                  system::failure_of("gnuplot", gnuplot, status),
                  status > signals ? "try it by hand: " + system::shell_command(command_of(test))
                                   : "install a build that can: apt-get install gnuplot-nox");
}

std::optional<system::OutputFile> add_plot(system::FileList& files, const std::string& path) {
  if (path.empty()) return std::nullopt;
  const system::OutputFile file = files.add_output(system::plot_output, path);
  require_gnuplot(file.format());
  return file;
}

std::string svg(const Plot& plot) { return drawn(formats[0], plot, "the figure"); }

std::unique_ptr<system::PendingFile> draw_pending_plot(const system::OutputFile& file,
                                                       const Plot& plot) {
  const Format& format = gnuplot_format(file.format());
  auto pending = std::make_unique<system::PendingFile>(file.path());
  std::string text = drawn(format, plot, file.path().string());
  text.insert(format.place_of_mark(text), format.mark);
  pending->write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  return pending;
}

void draw_plot(const system::OutputFile& file, const Plot& plot) {
  draw_pending_plot(file, plot)->commit();
}

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

#include "plot/gnuplot.h"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "system/error.h"
#include "system/file.h"
#include "system/memory_file.h"
#include "system/program.h"

namespace twrench::plot {
namespace {

constexpr std::size_t longest_figure = 1U << 30U;  // Bytes.

/// An output format of gnuplot.
struct Format {
  std::string_view ending;
  std::string_view terminal;
  std::string_view last_bytes;  ///< the end of a complete file, ignoring white space
};

constexpr std::array<Format, 3> formats{{{".svg", "svg", "</svg>"},
                                         {".pdf", "pdfcairo", "%%EOF"},
                                         {".png", "pngcairo", "IEND\xae\x42\x60\x82"}}};

const Format& format_of(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  for (const Format& format : formats) {
    if (ending == format.ending) return format;
  }
  throw InvalidArgument(fmt::format("plot {}", path), "its name must end in .svg, .pdf or .png");
}

/// Starts gnuplot without the user's ~/.gnuplot and environment settings, so that plots are
/// reproducible.
system::ChildProcess start(const std::vector<std::string>& arguments,
                           int output = system::ChildProcess::output_dropped) {
  std::vector<std::string> command{"gnuplot", "--default-settings"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return system::start_program<PlotError>(command, "install it: apt-get install gnuplot-nox", {},
                                          output);
}

/// The plot has the same size in all formats, each in its own units; PNG has twice the resolution.
std::string terminal(const Format& format, const Plot& plot) {
  const std::string start =
      fmt::format("set encoding utf8\nset terminal {} enhanced size ", format.terminal);
  if (format.ending == ".svg") {
    return start + fmt::format("{},{} font 'DejaVu Sans,13' background '#ffffff'\n", plot.width,
                               plot.height);
  }
  if (format.ending == ".pdf") {
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
    throw PlotError("cannot draw " + name,
                    fmt::format("gnuplot ended with exit status {}: {}", status,
                                system::error_summary(gnuplot.error_output())));
  }
}

/// gnuplot does not check its own writes.
void require_complete(std::string_view text, const Format& format, const std::string& name) {
  while (text.ends_with('\n')) text.remove_suffix(1);
  if (text.ends_with(format.last_bytes)) return;
  throw system::FileError("cannot write " + name, "gnuplot left it incomplete",
                          "check whether the disk is full");
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

void require_gnuplot(const std::string& path) {
  const Format& format = format_of(path);
  system::ChildProcess gnuplot = start({"-e", fmt::format("set terminal {}", format.terminal)});
  if (gnuplot.wait() == 0) return;
  throw PlotError(fmt::format("gnuplot cannot write {}", path),
                  system::error_summary(gnuplot.error_output()),
                  "install a build that can: apt-get install gnuplot-nox");
}

std::string svg(const Plot& plot) {
  const system::MemoryFile file("");
  draw(file.descriptor(), formats[0], plot, "the figure");
  std::string text = file.contents();
  require_complete(text, formats[0], "the figure");
  return text;
}

std::unique_ptr<system::PendingFile> draw_pending_plot(const std::string& path, const Plot& plot) {
  const Format& format = format_of(path);
  auto file = std::make_unique<system::PendingFile>(path);
  draw(file->descriptor(), format, plot, path);
  if (!file->is_direct()) {
    const std::vector<std::uint8_t> bytes = system::read_file(file->path(), longest_figure);
    require_complete({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, format, path);
  }
  return file;
}

void draw_plot(const std::string& path, const Plot& plot) {
  draw_pending_plot(path, plot)->commit();
}

}  // namespace twrench::plot

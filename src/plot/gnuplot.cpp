#include "plot/gnuplot.h"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "system/error.h"
#include "system/file.h"
#include "system/pending_file.h"
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
system::ChildProcess start(const std::vector<std::string>& arguments) {
  std::vector<std::string> command{"gnuplot", "--default-settings"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return system::start_program<PlotError>(command, "install it: apt-get install gnuplot-nox");
}

/// The same size in all formats, each in its own units; PNG has twice the resolution.
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

/// gnuplot does not check its own writes.
bool is_complete(const std::filesystem::path& path, const Format& format) {
  const std::vector<std::uint8_t> bytes = system::read_file(path, longest_figure);
  std::size_t size = bytes.size();
  while (size > 0 && bytes[size - 1] == '\n') --size;
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), size);
  return text.ends_with(format.last_bytes);
}

/// Draws the plot into the file; `name` is what messages call it.
void draw(const std::filesystem::path& file, const Format& format, const Plot& plot,
          const std::string& name) {
  const std::string script = terminal(format, plot) +
                             fmt::format("set output {}\n", gnuplot_string(file.string())) +
                             plot.script + "\nunset output\n";
  system::ChildProcess gnuplot = start({});
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(script.data());
  gnuplot.write({bytes, script.size()});
  if (const int status = gnuplot.wait(); status != 0) {
    throw PlotError("cannot draw " + name,
                    fmt::format("gnuplot ended with exit status {}: {}", status,
                                system::last_words(gnuplot.error_output())));
  }
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
                  system::last_words(gnuplot.error_output()),
                  "install a build that can: apt-get install gnuplot-nox");
}

std::string svg(const Plot& plot) {
  // Never committed, and so removed.
  const system::PendingFile file(std::filesystem::temp_directory_path() / "twrench-figure.svg");
  draw(file.path(), formats[0], plot, "the figure");
  const std::vector<std::uint8_t> bytes = system::read_file(file.path(), longest_figure);
  return {bytes.begin(), bytes.end()};
}

void draw_plot(const std::string& path, const Plot& plot) {
  const Format& format = format_of(path);
  system::PendingFile file(path);
  draw(file.path(), format, plot, path);
  if (!file.is_direct() && !is_complete(file.path(), format)) {
    throw system::FileError("cannot write " + path, "gnuplot left it incomplete",
                            "check whether the disk is full");
  }
  file.commit();
}

}  // namespace twrench::plot

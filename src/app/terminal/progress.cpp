#include "app/terminal/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "app/terminal/message.h"
#include "base/enumeration.h"

namespace twrench::app {
namespace {

using Json = nlohmann::ordered_json;

/// "1:02:03" or "2:03"
std::string clock_text(double seconds) {
  const long s = std::lround(seconds);
  if (s >= 3600) return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
  return fmt::format("{}:{:02}", s / 60, s % 60);
}

/// Writes complete lines at once. The caller of an Open Job Description task reads them; if it has
/// exited, that is not an error. A line break within a value would forge a line, so values are
/// escaped.
template <typename... T>
void print_openjd(fmt::format_string<T...> format, const T&... values) {
  static_cast<void>(std::fputs(format_message<T...>(format, values...).c_str(), stdout));
  static_cast<void>(std::fflush(stdout));
}

/// Whether standard error is a terminal that can redraw a line.
bool can_redraw() {
  const char* const terminal = std::getenv("TERM");
  return isatty(STDERR_FILENO) != 0 && terminal != nullptr && std::string_view(terminal) != "dumb";
}

int terminal_columns() {
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  const char* const columns = std::getenv("COLUMNS");
  const int told = columns == nullptr ? 0 : std::atoi(columns);  // 0 if it is not a number
  return told > 0 ? told : 80;
}

std::string summary_json(const Summary& summary, double rate) {
  Json json{{"frames", summary.frames}, {"seconds", summary.seconds}, {"frames_per_second", rate}};
  if (summary.frames_folder) json["frames_folder"] = summary.frames_folder->string();
  if (summary.film) json["film"] = summary.film->string();
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

}  // namespace

std::string bar_line(double share, const std::string& figures, int columns) {
  constexpr std::size_t widest = 30, narrowest = 5, frame = 3;  // frame: "[] "
  // The last column would wrap.
  const auto room = static_cast<std::size_t>(std::max(columns - 1, 1));
  std::string line = figures;
  if (room >= figures.size() + narrowest + frame) {
    const std::size_t width = std::min(widest, room - figures.size() - frame);
    const auto filled = static_cast<std::size_t>(share * static_cast<double>(width));
    line = fmt::format("[{:.<{}}] {}", std::string(filled, '#'), width, figures);
  }
  line.resize(room, ' ');
  return line;
}

void Progress::tell_failure_of(const std::function<void()>& work, const std::string& style) {
  try {
    work();
  } catch (const std::exception& error) {
    if (style == "openjd") print_openjd("openjd_fail: {}\n", std::string(error.what()));
    throw;
  }
}

Progress::Style Progress::style_called(const std::string& name) {
  if (name == "auto") return can_redraw() ? Style::bar : Style::plain;
  return find_enumerator<Style>(name, "--progress");
}

void Progress::update(int done, int total) {
  using std::chrono::milliseconds;
  const Clock::time_point now = Clock::now();
  if (style_ == Style::none || (now < next_ && done < total)) return;
  next_ = now + (style_ == Style::plain    ? milliseconds(5000)
                 : style_ == Style::openjd ? milliseconds(1000)
                                           : milliseconds(100));
  draw(done, total, std::chrono::duration<double>(now - start_).count());
  open_ = style_ == Style::bar;
}

void Progress::draw(int done, int total, double seconds) const {
  const double rate = seconds > 0.0 ? done / seconds : 0.0;
  const double left = rate > 0.0 ? (total - done) / rate : 0.0;
  if (style_ == Style::json) {
    say("{{\"frames_done\": {}, \"frames_total\": {}, \"seconds\": {:.3f}, "
        "\"frames_per_second\": {:.3f}, \"seconds_left\": {:.3f}}}\n",
        done, total, seconds, rate, left);
  } else if (style_ == Style::openjd) {
    print_openjd("openjd_progress: {:.1f}\nopenjd_status: {} of {} frames, {} left\n",
                 100.0 * done / total, done, total, clock_text(left));
  } else if (style_ == Style::plain) {
    say("{} of {} frames, {:.1f} frames/s, {} left\n", done, total, rate, clock_text(left));
  } else {
    const std::string figures =
        fmt::format("{}/{}  {:.1f} frames/s  {} left", done, total, rate, clock_text(left));
    say("\r{}", bar_line(static_cast<double>(done) / total, figures, terminal_columns()));
    static_cast<void>(std::fflush(stderr));
  }
}

void Progress::note(const std::string& text) const {
  if (style_ == Style::bar || style_ == Style::plain) say("twrench: note: {}\n", text);
}

void Progress::warn(const std::string& text) {
  finish();
  twrench::app::warn(text, style_ == Style::json);
}

void Progress::summarize(const Summary& summary) {
  if (style_ == Style::none) return;
  finish();
  const double rate = static_cast<double>(summary.frames) / summary.seconds;
  if (style_ == Style::json) return say("{}\n", summary_json(summary, rate));
  std::string text =
      fmt::format("{} frames in {:.1f} s, {:.1f} frames/s", summary.frames, summary.seconds, rate);
  if (summary.frames_folder) text += "; frames in " + summary.frames_folder->string();
  if (summary.film) {
    text += *summary.film == "-" ? "; video on standard output"
                                 : "; video in " + summary.film->string();
  }
  say("{}\n", text);
}

void Progress::finish() {
  if (open_.exchange(false)) say("\n");
}

}  // namespace twrench::app

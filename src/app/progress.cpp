#include "app/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "app/message.h"

namespace twrench {
namespace {

/// "1:02:03" or "2:03"
std::string clock_text(double seconds) {
  const long s = std::lround(seconds);
  if (s >= 3600) return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
  return fmt::format("{}:{:02}", s / 60, s % 60);
}

/// Whole lines, at once. Who starts this program for an Open Job Description reads them; that it
/// went away is no reason to end.
void print_openjd(const std::string& lines) {
  static_cast<void>(std::fputs((lines + "\n").c_str(), stdout));
  static_cast<void>(std::fflush(stdout));
}

}  // namespace

void Progress::tell_failure_of(const std::function<void()>& work, const std::string& style) {
  try {
    work();
  } catch (const std::exception& error) {
    if (style == "openjd") print_openjd(fmt::format("openjd_fail: {}", error.what()));
    throw;
  }
}

void Progress::add_option(CLI::App& command, std::string& style) {
  command.add_option("--progress", style, "auto, bar, plain, json, openjd or none")
      ->check(CLI::IsMember({"auto", "bar", "plain", "json", "openjd", "none"}))
      ->capture_default_str();
}

Progress::Style Progress::style_called(const std::string& name) {
  if (name == "bar") return Style::bar;
  if (name == "json") return Style::json;
  if (name == "openjd") return Style::openjd;
  if (name == "none") return Style::none;
  const bool terminal = isatty(STDERR_FILENO) != 0;
  return name == "auto" && terminal ? Style::bar : Style::plain;
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
    print_openjd(fmt::format("openjd_progress: {:.1f}\nopenjd_status: {} of {} frames, {} left",
                             100.0 * done / total, done, total, clock_text(left)));
  } else if (style_ == Style::plain) {
    say("{} of {} frames, {:.1f} frames/s, {} left\n", done, total, rate, clock_text(left));
  } else {
    constexpr int width = 30;
    const auto filled = static_cast<std::size_t>(width * static_cast<double>(done) / total);
    say("\r[{:.<{}}] {}/{}  {:.1f} frames/s  {} left \x1b[K", std::string(filled, '#'), width, done,
        total, rate, clock_text(left));
    static_cast<void>(std::fflush(stderr));
  }
}

void Progress::note(const std::string& text) const {
  if (style_ == Style::bar || style_ == Style::plain) say("twrench: note: {}\n", text);
}

void Progress::finish() {
  if (open_) say("\n");
  open_ = false;
}

}  // namespace twrench

#pragma once

#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "base/termination.h"

namespace twrench {

/// What a run made, for its last line.
struct Summary {
  std::size_t frames = 0;
  double seconds = 0.0;  ///< wall time
  std::optional<std::filesystem::path> frames_folder;
  std::optional<std::filesystem::path> film;
};

/// How far a run has come, on standard error: a bar that is redrawn on a terminal, a plain line now
/// and then elsewhere, a JSON object a line for programs, or nothing. Or, on standard output, the
/// lines that an Open Job Description runtime listens for: openjd_progress: 42.0, openjd_status.
class Progress {
 public:
  /// Adds --progress to a command.
  static void add_option(CLI::App& command, std::string& style);

  /// Whether that is json. Also for commands without it, where it is not.
  static bool is_json(const CLI::App& command);

  /// Does the work; where it throws, and the style is openjd, says openjd_fail before that goes on.
  static void tell_failure_of(const std::function<void()>& work, const std::string& style);

  /// `style` is auto, bar, plain, json, openjd or none; auto is a bar on a terminal that
  /// can draw over a line, and plain elsewhere.
  explicit Progress(const std::string& style) : style_(style_called(style)) {}

  /// To be called after each frame with the number done so far, from one thread at a time.
  void update(int done, int total);

  /// A line for people, before the first frame.
  void note(const std::string& text) const;

  /// A line that is not to be missed: in every style.
  void warn(const std::string& text);

  /// The last line.
  void summarize(const Summary& summary);

  /// Ends the bar's line. Called by the destructor where it was not.
  void finish();
  ~Progress() { finish(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  enum class Style { bar, plain, json, openjd, none };

  static Style style_called(const std::string& name);
  void draw(int done, int total, double seconds) const;

  Style style_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_;
  std::atomic<bool> open_ = false;  ///< a bar's line has not been ended
  const TerminationAction end_of_line_{[this](TerminationMessage&) { finish(); }};
};

/// A bar before the figures, as wide as fits a terminal of so many columns, with spaces behind that
/// cover an earlier, longer line. Without the bar, and the figures cut, where there is no room.
std::string bar_line(double share, const std::string& figures, int columns);

}  // namespace twrench

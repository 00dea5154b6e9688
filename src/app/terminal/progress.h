#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "system/termination.h"

namespace twrench::app {

/// The result of a run, for its last line.
struct Summary {
  /// Number of frames.
  std::size_t frames = 0;
  /// Wall time in s.
  double seconds = 0.0;
  /// Folder of the frames, if any were written.
  std::optional<std::filesystem::path> frames_folder;
  /// The video, if one was written; "-" for standard output.
  std::optional<std::filesystem::path> film;
};

/// Reports the progress of a run on standard error: a bar that is redrawn on a terminal, an
/// occasional plain line elsewhere, a JSON object per line for programs, or nothing. With openjd it
/// prints the lines of the Open Job Description protocol on standard output: openjd_progress: 42.0,
/// openjd_status.
class Progress {
 public:
  /// Does the work. If it throws and the style is openjd, prints openjd_fail before rethrowing.
  static void tell_failure_of(const std::function<void()>& work, const std::string& style);

  /// `style` is auto, bar, plain, json, openjd or none; auto is bar on a terminal that can redraw a
  /// line, and plain elsewhere.
  explicit Progress(const std::string& style) : style_(style_called(style)) {}

  /// Call this after each frame with the number done so far, from one thread at a time.
  void update(int done, int total);

  /// Prints a note for users, before the first frame.
  void note(const std::string& text) const;

  /// Prints a warning in every style.
  void warn(const std::string& text);

  /// Prints the last line.
  void summarize(const Summary& summary);

  /// Ends the bar's line. The destructor calls it too.
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
  std::atomic<bool> open_ = false;  ///< Whether a bar's line is unfinished.
  const system::TerminationAction end_of_line_{[this](system::TerminationMessage&) { finish(); }};
};

/// Returns a bar followed by `figures`, as wide as fits a terminal of that many columns, padded
/// with spaces that erase an earlier, longer line. Omits the bar and truncates the text if there is
/// no room.
std::string bar_line(double share, const std::string& figures, int columns);

}  // namespace twrench::app

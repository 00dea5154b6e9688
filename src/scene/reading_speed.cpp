#include "scene/reading_speed.h"

#include <fmt/format.h>

#include <algorithm>

namespace twrench::scene {
namespace {

/// Returns the number of characters of UTF-8 text: all bytes but those that continue one.
double characters(const std::string& text) {
  return static_cast<double>(
      std::ranges::count_if(text, [](char byte) { return (byte & 0xC0) != 0x80; }));
}

}  // namespace

double reading_speed(const Shot& shot) {
  return shot.scene.caption ? characters(*shot.scene.caption) / *shot.scene.length : 0;
}

std::vector<std::string> hasty_captions(const Scene& film) {
  std::vector<std::string> warnings;
  for (const Shot& shot : film.shots) {
    const double speed = reading_speed(shot);
    if (speed <= fastest_reading) continue;
    const double length = *shot.scene.length;
    warnings.push_back(
        fmt::format("{}.caption: {:.1f} characters a second are too fast to read: give the shot "
                    "{:.2f} s, not {:.2f} s",
                    shot.place, speed, speed * length / fastest_reading, length));
  }
  return warnings;
}

}  // namespace twrench::scene

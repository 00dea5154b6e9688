#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace twrench::scene {

/// Characters a second of a caption that most viewers can read beside a picture (the limit for
/// subtitles of broadcasters and streaming services).
inline constexpr double fastest_reading = 17;

/// Returns the number of characters of a shot's caption for each second of the shot; 0 without one.
double reading_speed(const Shot& shot);

/// Returns a warning for each shot whose caption must be read faster than `fastest_reading`.
std::vector<std::string> hasty_captions(const Scene& film);

}  // namespace twrench::scene

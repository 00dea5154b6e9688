#pragma once

#include <functional>
#include <span>

namespace twrench::sound {

/// Receives samples, left and right alternating. Returns whether it takes more.
using Sink = std::function<bool(std::span<const float>)>;

/// Returns the integrated loudness of a sound in LUFS (ITU-R BS.1770), which `play` passes to its
/// argument in pieces; -infinity if it is silent. A sound too short to have a loudness, less than
/// 0.4 s, is repeated.
double loudness(const std::function<void(const Sink&)>& play);

}  // namespace twrench::sound

#pragma once

namespace twrench::sound {

/// Samples per second and channel.
inline constexpr int sample_rate = 48'000;

/// Number of channels: left and right. The samples of both alternate.
inline constexpr int channels = 2;

}  // namespace twrench::sound

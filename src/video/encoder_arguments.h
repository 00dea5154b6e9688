#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "video/codec.h"

namespace twrench::video {

/// Arguments of ffmpeg.
using Arguments = std::vector<std::string>;

/// The options with which ffmpeg says nothing but errors, stops at the first, and asks nothing.
inline constexpr const char* quiet_options = "-hide_banner -loglevel error -xerror -y";

/// Splits a text at its spaces.
Arguments words(const std::string& text);

/// Returns the arguments of several groups, in order.
Arguments joined(std::initializer_list<Arguments> groups);

/// Returns the arguments up to the input: raw frames on standard input, as Yuv420::bytes() provides
/// them, or RGB or RGBA where VideoFormat::is_rgb(). Throws FilmSizeError for odd sizes, which
/// yuv420p does not allow, OutOfRange for an invalid rate, and InvalidArgument for transparent
/// frames in a container that does not keep their alpha.
Arguments input_arguments(const VideoFormat& format);

/// Returns the arguments from there to the output file: filters, codec and container, tagged
/// BT.709.
Arguments output_arguments(const VideoFormat& format);

/// Returns both. An animated image with a palette that they made would need memory for all of its
/// frames; see PalettePasses.
Arguments encoder_arguments(const VideoFormat& format);

}  // namespace twrench::video

#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "video/codec.h"

namespace twrench::video {

/// Arguments of ffmpeg.
using Arguments = std::vector<std::string>;

/// Options that make ffmpeg print only errors, stop at the first one, and never prompt.
inline constexpr const char* quiet_options = "-hide_banner -loglevel error -xerror -y";

/// Returns the arguments of several groups, in order.
Arguments joined(std::initializer_list<Arguments> groups);

/// Returns the arguments up to the input, which is raw frames on standard input: RGB or RGBA if
/// VideoFormat::is_rgb(), otherwise planes as Yuv420::bytes() provides them. Throws FilmSizeError
/// for odd sizes, which yuv420p does not allow, OutOfRange for an invalid rate, and InvalidArgument
/// for transparent frames in a container that does not keep their alpha.
Arguments input_arguments(const VideoFormat& format);

/// Returns the arguments between the input and the output file: filters, codec and container,
/// tagged BT.709. Throws as chosen_quality().
Arguments output_arguments(const VideoFormat& format);

/// Returns both. For an animated image with a palette, these arguments would keep all frames in
/// memory; use PalettePasses instead.
Arguments encoder_arguments(const VideoFormat& format);

}  // namespace twrench::video

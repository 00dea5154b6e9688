#pragma once

#include "image/image.h"

namespace twrench::draw {

/// Returns the mean, in linear light, of two pictures of the same size: `share` of the second and
/// the rest of the first. Both are RGB, or RGBA with unpremultiplied alpha.
image::Image cross_fade(const image::Image& from, const image::Image& to, double share);

}  // namespace twrench::draw

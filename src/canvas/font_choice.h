#pragma once

#include <hb.h>

#include <span>
#include <vector>

#include "canvas/font.h"

namespace twrench::canvas {

/// Of each character of a text the font that sets it: `font`, or its fallback for what it lacks. A
/// letter has all its marks of one font where one has them all. The digits are of one font. Spaces
/// and signs that both fonts have go with the letters or digits before them, but brackets and
/// quotation marks with those after the opening one.
std::vector<const Font*> choose_fonts(std::span<const hb_codepoint_t> text, const Font& font);

}  // namespace twrench::canvas

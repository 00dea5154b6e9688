#pragma once

#include <hb.h>

#include <span>
#include <vector>

#include "canvas/font.h"

namespace twrench::canvas {

/// Returns the font of each character of a text: `font`, or its fallback for characters that it
/// lacks. A letter and its marks have the same font if one font has them all. All digits have the
/// same font. Spaces and signs that both fonts have take the font of the letters or digits before
/// them; brackets and quotation marks take the font of those after the opening one.
std::vector<const Font*> choose_fonts(std::span<const hb_codepoint_t> text, const Font& font);

}  // namespace twrench::canvas

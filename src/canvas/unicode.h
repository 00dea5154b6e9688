#pragma once

#include <hb.h>

// What Unicode says of a character, from HarfBuzz's tables.
namespace twrench::canvas {

hb_script_t script_of(hb_codepoint_t character);

/// Whether characters of many scripts have it: spaces, signs, digits, marks.
bool is_shared(hb_script_t script);

hb_unicode_general_category_t category_of(hb_codepoint_t character);

/// Whether it stands on, under or around the letter before it.
bool is_mark(hb_codepoint_t character);

}  // namespace twrench::canvas

#pragma once

#include <hb.h>

// Unicode properties of characters, from HarfBuzz's tables.
namespace twrench::canvas {

hb_script_t script_of(hb_codepoint_t character);

/// Returns whether it is the script of characters that many scripts share: spaces, signs, digits,
/// marks.
bool is_shared(hb_script_t script);

hb_unicode_general_category_t category_of(hb_codepoint_t character);

/// Returns whether the character is set on, under or around the letter before it.
bool is_mark(hb_codepoint_t character);

}  // namespace twrench::canvas

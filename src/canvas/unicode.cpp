#include "canvas/unicode.h"

namespace twrench::canvas {

hb_script_t script_of(hb_codepoint_t character) {
  return hb_unicode_script(hb_unicode_funcs_get_default(), character);
}

bool is_shared(hb_script_t script) {
  return script == HB_SCRIPT_COMMON || script == HB_SCRIPT_INHERITED || script == HB_SCRIPT_UNKNOWN;
}

hb_unicode_general_category_t category_of(hb_codepoint_t character) {
  return hb_unicode_general_category(hb_unicode_funcs_get_default(), character);
}

bool is_mark(hb_codepoint_t character) {
  switch (category_of(character)) {
    case HB_UNICODE_GENERAL_CATEGORY_NON_SPACING_MARK:
    case HB_UNICODE_GENERAL_CATEGORY_SPACING_MARK:
    case HB_UNICODE_GENERAL_CATEGORY_ENCLOSING_MARK:
      return true;
    default:
      return false;
  }
}

}  // namespace twrench::canvas

#pragma once

#include "base/error.h"

namespace twrench {

/// A text has a character that neither the font nor its fallback can draw.
class MissingGlyph : public UsageError {
 public:
  MissingGlyph(const std::string& quantity, const std::string& why, char32_t character)
      : UsageError(quantity, why), character_(character) {}

  char32_t character() const noexcept { return character_; }

 private:
  char32_t character_;
};

}  // namespace twrench

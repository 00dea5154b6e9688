#pragma once

#include <twrench/base/error.h>

namespace twrench::canvas {

/// A text has a character that neither the font nor its fallback can draw.
class MissingGlyph : public InvalidArgument {
 public:
  MissingGlyph(const std::string& quantity, const std::string& why, char32_t character)
      : InvalidArgument(quantity, why), character_(character) {}

  char32_t character() const noexcept { return character_; }

 private:
  char32_t character_;
};

}  // namespace twrench::canvas

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "canvas/font.h"
#include "picture/compose/element.h"
#include "picture/compose/layout.h"
#include "picture/look/theme.h"

namespace twrench::picture {

/// Breaks a text at its spaces into the fewest lines, of about the same length, that are at most
/// `width` em wide. Returns nothing if it needs more than `most` lines.
std::optional<std::vector<std::string>> broken_into_lines(const canvas::Font& font,
                                                          const std::string& text, double width,
                                                          int most);

/// The caption of a shot: centred lines at the bottom of the picture, with a halo that keeps them
/// legible on any background.
class Caption final : public Element {
 public:
  /// Throws InvalidArgument if the text does not fit, and MissingGlyph if the typeface lacks one of
  /// its characters.
  Caption(const std::string& text, const Layout::Caption& place, const canvas::Typeface& typeface,
          const OverlayColors& colors);

  std::vector<Layer> draw(const timeline::FrameState& state) override;

 private:
  Layer layer_;
};

}  // namespace twrench::picture

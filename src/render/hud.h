#pragma once

#include <vector>

#include "render/element.h"
#include "render/words.h"

namespace twrench {

/// Returns the colour that identifies a method in a comparison.
Color take_color(const OverlayColors& colors, std::size_t take);

/// The text of the video: title, method, and the readouts of time, drift and flips.
class Hud : public Element {
 public:
  /// All but `scene` and `takes` outlive it. Throws MissingGlyph where the typeface lacks a
  /// character of the title or, without one, of the scene's name.
  Hud(const Scene& scene, const std::vector<Take>& takes, const Layout& layout,
      const Typeface& typeface, const OverlayColors& colors);

  std::vector<PendingLayer> draw(const Moment& moment) override;

  /// Returns the areas of the text blocks, which labels must keep clear of.
  std::vector<Area> extents() const;

 private:
  std::vector<WordBlock> blocks_;
};

}  // namespace twrench

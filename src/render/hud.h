#pragma once

#include <vector>

#include "render/element.h"
#include "render/words.h"

namespace twrench {

/// The colours by which the takes of a comparison are told apart.
Color take_color(const OverlayColors& colors, std::size_t take);

/// What the film says in words: title, method, time, drift, flips.
class Hud : public Element {
 public:
  /// All but `scene` and `takes` outlive it. Throws MissingGlyph where the typeface lacks a
  /// character of the title or, without one, of the scene's name.
  Hud(const Scene& scene, const std::vector<Take>& takes, const Layout& layout,
      const Typeface& typeface, const OverlayColors& colors);

  std::vector<PendingLayer> draw(const Moment& moment) override;

  /// Where words are, to be kept clear.
  std::vector<Area> extents() const;

 private:
  std::vector<WordBlock> blocks_;
};

}  // namespace twrench

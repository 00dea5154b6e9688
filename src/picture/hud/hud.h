#pragma once

#include <vector>

#include "picture/compose/element.h"
#include "picture/hud/text_block.h"

namespace twrench::picture {

/// Returns whether text needs a panel behind it because the background is arbitrary.
bool needs_panels(const scene::Look& look);

/// Returns the colour that identifies a method in a comparison.
Color solution_color(const OverlayColors& colors, std::size_t solution);

/// The text of the video: the title, the readouts of time, drift and flips with a remark on what
/// happens, and the headings and descriptions of views.
class Hud : public Element {
 public:
  /// `typeface` and `colors` must outlive the object. Throws MissingGlyph if the typeface lacks a
  /// character of the title or, without one, of the scene's name.
  Hud(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
      const Layout& layout, const canvas::Typeface& typeface, const OverlayColors& colors);

  std::vector<Layer> draw(const timeline::FrameState& state) override;

  /// Returns the areas of the text blocks, which labels must keep clear of.
  std::vector<image::Area> extents() const;

 private:
  std::vector<TextBlock> blocks_;
};

}  // namespace twrench::picture

#pragma once

#include <string>
#include <vector>

#include "gl/backend.h"
#include "scene/scene.h"

namespace twrench::film {

/// The pictures that the views of a page show until they draw, as <img> elements.
struct PagePictures {
  /// The scene at t = 0 as in the film, without text, at most 800 pixels wide and high. A page that
  /// cannot run shows it too.
  std::string poster;
  /// All stills of page::stills_of(), one below the other. The page hides it.
  std::string stills;
};

/// Returns a picture of each scene at t = 0, without text and at most 480 pixels wide, as <img>
/// elements. Throws GlError.
std::vector<std::string> still_pictures(const std::vector<scene::Scene>& scenes,
                                        const gl::BackendChoice& backend);

/// Draws the pictures of a page, with the article or without. Throws GlError.
PagePictures page_pictures(const scene::Scene& scene, bool has_article,
                           const gl::BackendChoice& backend);

}  // namespace twrench::film

#pragma once

#include "film/page_pictures.h"
#include "scene/scene.h"

namespace twrench::app {

/// Returns the pictures of a page. If nothing can be drawn, warns and returns none, because a page
/// works without pictures.
film::PagePictures pictures_or_nothing(const scene::Scene& scene, bool has_article);

}  // namespace twrench::app

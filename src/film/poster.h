#pragma once

#include <string>

#include "gl/backend.h"
#include "image/image.h"
#include "scene/scene.h"

namespace twrench::film {

/// Returns the picture that a page shows if it cannot draw: the scene at t = 0 as in the film,
/// without text, at most 960 pixels wide and high. Throws GlError.
image::Image poster(const scene::Scene& scene, const gl::BackendChoice& backend);

/// Returns that picture as an <img> element that contains its bytes. Throws GlError.
std::string poster_html(const scene::Scene& scene, const gl::BackendChoice& backend);

}  // namespace twrench::film

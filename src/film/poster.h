#pragma once

#include "gl/backend.h"
#include "image/image.h"
#include "scene/scene.h"

namespace twrench::film {

/// Returns the picture that stands where a page cannot draw: the scene at t = 0 as the film shows
/// it, without text, at most 960 pixels wide and high. Throws GlError.
image::Image poster(const scene::Scene& scene, const gl::BackendChoice& backend);

}  // namespace twrench::film

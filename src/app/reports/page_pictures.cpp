#include "app/reports/page_pictures.h"

#include <fmt/format.h>

#include "app/terminal/message.h"
#include "gl/error.h"

namespace twrench::app {

film::PagePictures pictures_or_nothing(const scene::Scene& scene, bool has_article) try {
  return film::page_pictures(scene, has_article, {});
} catch (const gl::GlError& error) {
  warn(fmt::format("the page has no fallback pictures: {}", error.what()));
  return {};
}

}  // namespace twrench::app

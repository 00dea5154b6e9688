#include "app/reports/poster.h"

#include <fmt/format.h>

#include "app/terminal/message.h"
#include "film/poster.h"
#include "gl/error.h"

namespace twrench::app {

std::string poster_or_nothing(const scene::Scene& scene) try {
  return film::poster_html(scene, {});
} catch (const gl::GlError& error) {
  warn(fmt::format("the page has no fallback picture: {}", error.what()));
  return {};
}

}  // namespace twrench::app

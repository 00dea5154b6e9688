// Compares the OpenGL backends: they draw the same picture if they use the same rasteriser.
#include <gtest/gtest.h>
#include <twrench/base/error.h>
#include <twrench/math/so3.h>

#include "draw/pose_renderer.h"
#include "gl/backend.h"
#include "image/compare.h"
#include "picture/t_wrench.h"

namespace twrench::draw {
namespace {

using picture::t_wrench;

/// Draws in software through the backend; returns nothing if it is not usable.
std::optional<image::Image> drawn_with(const gl::BackendChoice& choice, const scene::Scene& scene) {
  try {
    const auto opened = gl::open_context(choice);
    return PoseRenderer(*opened.context, scene).draw(so3::exp({0.7, -0.9, 0.4}));
  } catch (const Error&) {
    return std::nullopt;
  }
}

TEST(Backends, GiveTheSameImage) {
  scene::Scene transparent = t_wrench(320, 180);
  transparent.look.transparent = true;
  for (const scene::Scene& scene : {t_wrench(320, 180), transparent}) {
    const auto osmesa = drawn_with({gl::Backend::osmesa, {}}, scene);
    const auto egl = drawn_with({gl::Backend::egl, "software"}, scene);
    if (!osmesa || !egl) GTEST_SKIP() << "one of OSMesa and EGL's software cannot be used here";
    // The thresholds of the golden images, which allow for different releases of Mesa.
    const auto difference = image::compare(*osmesa, *egl, 4);
    ASSERT_TRUE(difference.has_value());
    EXPECT_LE(difference->share, 0.001);
    EXPECT_LE(difference->mean, 0.15);
  }
}

}  // namespace
}  // namespace twrench::draw

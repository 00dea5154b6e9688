#pragma once

#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>

#include "gl/backend.h"
#include "gl/context.h"

namespace twrench::gl {

/// Creates the tests' context, in software unless TWRENCH_TEST_EGL_DEVICE is the number of a
/// graphics card: with EGL if TWRENCH_TEST_BACKEND=egl, which runs every test with EGL only, or if
/// there is no OSMesa; otherwise with OSMesa.
inline std::unique_ptr<Context> make_test_context() {
  if (const char* const card = std::getenv("TWRENCH_TEST_EGL_DEVICE"))
    return make_egl_context(card);
  const char* const wanted = std::getenv("TWRENCH_TEST_BACKEND");
  const std::string backend = wanted == nullptr ? "" : wanted;
  if (backend == "egl") return make_egl_context("software");
  if (backend != "osmesa" && !backend.empty()) {
    throw std::invalid_argument("TWRENCH_TEST_BACKEND is osmesa or egl");
  }
  try {
    return make_osmesa_context();
  } catch (const GlError&) {
    if (!backend.empty()) throw;
    return make_egl_context("software");
  }
}

}  // namespace twrench::gl

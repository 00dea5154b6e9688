#pragma once

#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>

#include "gl/backend.h"

namespace twrench::gl {

/// What the tests draw with, in software wherever they run: EGL where TWRENCH_TEST_BACKEND=egl says
/// so, which takes every test over EGL alone, or where there is no OSMesa; else OSMesa.
inline std::unique_ptr<Context> make_test_context() {
  const char* const wanted = std::getenv("TWRENCH_TEST_BACKEND");
  const std::string backend = wanted == nullptr ? "" : wanted;
  if (backend == "egl") return make_egl_context("software");
  if (backend != "osmesa" && !backend.empty()) {
    throw std::invalid_argument("TWRENCH_TEST_BACKEND is osmesa or egl");
  }
  if (backend.empty() && backends().front().renderer.empty()) return make_egl_context("software");
  return make_osmesa_context();
}

}  // namespace twrench::gl

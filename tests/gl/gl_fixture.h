#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "gl/context.h"
#include "gl/functions.h"

namespace twrench::gl {

/// A context for each test, current.
class GlTest : public testing::Test {
 protected:
  std::unique_ptr<Context> context = make_osmesa_context();
  Functions gl{*context};
};

}  // namespace twrench::gl

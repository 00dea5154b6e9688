#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "gl/functions.h"
#include "gl/test_context.h"

namespace twrench::gl {

/// Provides a current context for each test.
class GlTest : public testing::Test {
 protected:
  std::unique_ptr<Context> context = make_test_context();
  Functions gl{*context};
};

}  // namespace twrench::gl

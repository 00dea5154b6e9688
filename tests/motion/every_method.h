#pragma once

#include <gtest/gtest.h>
#include <twrench/motion/method.h>

#include <ostream>
#include <string>

namespace twrench::motion {

/// Prints the method's name in test failures.
inline void PrintTo(const Method& method, std::ostream* out) { *out << method.name; }

/// INSTANTIATE_TEST_SUITE_P(All, Suite, every_method(), method_test_name) runs a test per method.
inline auto every_method() { return testing::ValuesIn(methods().begin(), methods().end()); }

inline std::string method_test_name(const testing::TestParamInfo<Method>& param) {
  std::string name(param.param.name);
  std::erase(name, '-');
  return name;
}

}  // namespace twrench::motion

#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace twrench {

/// Runs a tool that a test compares our output with, in a shell. The test fails if the tool does.
inline void run_command(const std::string& command) {
  EXPECT_EQ(std::system(command.c_str()), 0) << command;  // NOLINT(cert-env33-c): our own words
}

}  // namespace twrench

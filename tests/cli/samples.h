#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/twrench.h"

namespace twrench {

inline Eigen::Vector3d vector_of(const nlohmann::json& numbers) {
  const auto values = numbers.get<std::array<double, 3>>();
  return {values[0], values[1], values[2]};
}

/// The matrix of nine numbers in row-major order.
inline Eigen::Matrix3d matrix_of(const nlohmann::json& numbers) {
  const auto values = numbers.get<std::array<double, 9>>();
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(values.data());
}

/// The samples of a run of `twrench simulate`.
inline nlohmann::json samples(const ScratchFolder& folder, const std::string& words) {
  const Outcome run = run_twrench(folder, "simulate --format json " + words);
  EXPECT_EQ(run.code, 0) << words << "\n" << run.err;
  return run.code == 0 ? nlohmann::json::parse(run.out)["samples"] : nlohmann::json::array();
}

}  // namespace twrench

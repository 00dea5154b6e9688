#pragma once

#include <fmt/format.h>
#include <twrench/motion/exact.h>

#include <Eigen/Core>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "check/verdict/judge.h"
#include "recording/conventions/convention.h"
#include "recording/rows.h"
#include "scratch_folder.h"
#include "system/file.h"

namespace twrench::check {

/// The quantities in a file.
enum class Parts { rates, attitude, both };

/// A tumbling body whose motion is not a special case.
inline const Eigen::Vector3d moments(2, 3, 4);
inline const Eigen::Matrix3d inertia = moments.asDiagonal();
inline const Eigen::Vector3d omega(0.4, 1.5, 0.3);

inline motion::FreeBody tumbling_body() { return {inertia, omega}; }

inline Problem tumbling_problem() { return {.inertia = inertia}; }

/// Rows at `count` times from `start` on, every `step` s. `sample(t)` returns the motion at the
/// time t since `start`.
template <typename Motion>
std::vector<recording::Row> rows_of(const Motion& sample, std::size_t count, double step,
                                    double start = 0) {
  std::vector<recording::Row> rows;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) * step;
    const motion::Sample at = sample(t);
    rows.push_back({.number = i + 1, .t = start + t, .omega = at.omega, .X = at.X});
  }
  return rows;
}

/// The exact motion of tumbling_body() at `count` times.
inline std::vector<recording::Row> exact_rows(std::size_t count = 401, double step = 0.1,
                                              double start = 0) {
  const motion::ExactMotion exact(tumbling_body());
  return rows_of([&](double t) { return exact.at(t); }, count, step, start);
}

/// The rows as a CSV file with our own names for the columns, with all digits or this number of
/// decimals.
inline std::string csv_of(const std::vector<recording::Row>& rows, Parts parts, int decimals = -1) {
  const auto number = [decimals](double value) {
    return decimals < 0 ? fmt::format(",{:.17g}", value) : fmt::format(",{:.{}f}", value, decimals);
  };
  std::string text = "t";
  if (parts != Parts::rates) text += ",x11,x12,x13,x21,x22,x23,x31,x32,x33";
  if (parts != Parts::attitude) text += ",wx,wy,wz";
  text += "\n";
  for (const recording::Row& row : rows) {
    text += fmt::format("{:.12g}", row.t);
    for (int i = 0; i < 9 && parts != Parts::rates; ++i) text += number(row.X(i / 3, i % 3));
    for (int i = 0; i < 3 && parts != Parts::attitude; ++i) text += number(row.omega[i]);
    text += "\n";
  }
  return text;
}

inline recording::Convention own_names(Parts parts) {
  recording::Convention convention;
  convention.columns["t"] = "t";
  for (int i = 0; i < 9 && parts != Parts::rates; ++i) {
    const std::string name = fmt::format("x{}{}", i / 3 + 1, i % 3 + 1);
    convention.columns[name] = name;
  }
  for (const char* name : {"wx", "wy", "wz"}) {
    if (parts != Parts::attitude) convention.columns[name] = name;
  }
  return convention;
}

/// Writes the rows to a file and judges it.
inline Judgement judged(const std::vector<recording::Row>& rows, Parts parts,
                        const Problem& problem, int decimals = -1) {
  const ScratchFolder folder;
  system::write_file_atomically(folder / "rows.csv", csv_of(rows, parts, decimals));
  return judge(recording::Recording(folder / "rows.csv"), own_names(parts), problem);
}

inline double in_degrees(double angle) { return angle * 180 / std::numbers::pi; }

}  // namespace twrench::check

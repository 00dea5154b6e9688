#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/color.h"
#include "picture/look/material.h"

namespace twrench::picture {

/// linear_from_srgb() of a channel, from a table: tests ask for millions.
inline double linear_channel(int value) {
  static const std::array<double, 256> table = [] {
    std::array<double, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = linear_from_srgb(static_cast<int>(i));
    }
    return values;
  }();
  return table[static_cast<std::size_t>(value)];
}

inline Eigen::Vector3d linear(const Color& color) {
  return {linear_channel(color.red), linear_channel(color.green), linear_channel(color.blue)};
}

/// WCAG 2.1, "relative luminance".
inline double luminance(const Color& color) {
  return 0.2126 * linear_channel(color.red) + 0.7152 * linear_channel(color.green) +
         0.0722 * linear_channel(color.blue);
}

/// WCAG 2.1, "contrast ratio".
inline double contrast(const Color& a, const Color& b) {
  const auto [low, high] = std::minmax({luminance(a), luminance(b)});
  return (high + 0.05) / (low + 0.05);
}

/// Linear RGB as perceived with the three kinds of colour vision deficiency, and without. Machado,
/// Oliveira, Fernandes, "A Physiologically-based Model for Simulation of Color Vision Deficiency",
/// IEEE TVCG 15 (2009), severity 1.0.
inline std::vector<Eigen::Matrix3d> eyes() {
  Eigen::Matrix3d protan, deutan, tritan;
  protan << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116,
      1.051998;
  deutan << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940,
      0.968881;
  tritan << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367,
      0.303900;
  return {Eigen::Matrix3d::Identity(), protan, deutan, tritan};
}

/// CIE L*a*b* (D65) of linear sRGB.
inline Eigen::Vector3d lab(const Eigen::Vector3d& rgb) {
  Eigen::Matrix3d xyz_from_rgb;
  xyz_from_rgb << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
  const Eigen::Vector3d xyz =
      (xyz_from_rgb * rgb.cwiseMax(0).cwiseMin(1)).cwiseQuotient(Eigen::Vector3d(0.9505, 1, 1.089));
  const Eigen::Vector3d f = xyz.unaryExpr(
      [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; });
  return {116 * f.y() - 16, 500 * (f.x() - f.y()), 200 * (f.y() - f.z())};
}

/// The CIE76 difference for the type of vision that sees the least; 2.3 is just noticeable.
inline double distance(const Color& a, const Color& b) {
  double least = 1e9;
  for (const Eigen::Matrix3d& eye : eyes()) {
    least = std::min(least, (lab(eye * linear(a)) - lab(eye * linear(b))).norm());
  }
  return least;
}

}  // namespace twrench::picture

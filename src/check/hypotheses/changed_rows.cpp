#include "check/hypotheses/changed_rows.h"

#include <twrench/math/so3.h>
#include <twrench/motion/exact.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace twrench::check {

using recording::BodyAxes;
using recording::Row;

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::vector<Row> changed(std::span<const Row> rows, const Change& change) {
  const Matrix3d P = change.axes.matrix();
  const double sign = P.determinant();
  std::vector<Row> result(rows.begin(), rows.end());
  const Matrix3d rates_from_file = change.file_from_rates.inverse();
  for (Row& row : result) {
    const Vector3d file = change.factor * (change.file_from_rates * row.omega);
    row.X = (sign * row.X * change.offset.transpose() * P).eval();
    const Vector3d body = change.from_space_axes ? Vector3d(sign * row.X.transpose() * file)
                                                 : Vector3d(P.transpose() * file);
    row.omega = rates_from_file * body;
  }
  return result;
}

bool are_equivalent(const Matrix3d& inertia, const BodyAxes& a, const BodyAxes& b) {
  const Matrix3d S = b.matrix().transpose() * a.matrix();
  constexpr double least = 1e-12;
  return S.determinant() > 0 &&
         (S * inertia * S.transpose() - inertia).norm() <= least * inertia.norm();
}

std::vector<BodyAxes> distinct_axes(const Matrix3d& inertia, const BodyAxes& first) {
  std::vector<BodyAxes> distinct{first};
  for (const BodyAxes& axes : recording::all_body_axes()) {
    const bool is_new = std::ranges::none_of(
        distinct, [&](const BodyAxes& other) { return are_equivalent(inertia, axes, other); });
    if (is_new) distinct.push_back(axes);
  }
  return distinct;
}

double variation(const Matrix3d& inertia, std::span<const Row> rows) {
  Eigen::Array2d sum = Eigen::Array2d::Zero(), squares = Eigen::Array2d::Zero();
  for (const Row& row : rows) {
    const Vector3d L = inertia * row.omega;
    const Eigen::Array2d conserved(L.norm(), L.dot(row.omega));
    sum += conserved;
    squares += conserved.square();
  }
  const auto count = static_cast<double>(rows.size());
  const Eigen::Array2d mean = sum / count;
  return ((squares / count - mean.square()).max(0).sqrt() / mean).maxCoeff();
}

Matrix3d offset_between(const Matrix3d& inertia, std::span<const Row> rows,
                        std::span<const Row> turned, const BodyAxes& axes) {
  const Matrix3d P = axes.matrix();
  std::size_t stride = 1;
  const auto angle = [&](std::size_t i) {
    return so3::log(rows[i].X.transpose() * rows[i + stride].X).norm();
  };
  while (2 * stride < rows.size() / 2 && angle(0) < 1) stride *= 2;
  Matrix3d products = Matrix3d::Zero();
  for (std::size_t i = 0; i + stride < rows.size(); ++i) {
    const motion::ExactMotion exact({inertia, turned[i].omega});
    const Matrix3d turn = exact.at(turned[i + stride].t - turned[i].t).X;
    const Vector3d expected = P.determinant() * (P * so3::log(turn));
    products += expected * so3::log(rows[i].X.transpose() * rows[i + stride].X).transpose();
  }
  const Eigen::JacobiSVD<Matrix3d> svd(products, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  return svd.matrixU() * Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
}

namespace {

/// Whether the rows `b` have the same motion as `a` if their body's axes are turned by S.
bool are_turned(std::span<const Row> a, std::span<const Row> b, const Matrix3d& S) {
  constexpr double same = 1e-5;
  const double speed = a.front().omega.norm();
  for (std::size_t i = 0; i < a.size(); ++i) {
    if ((a[i].omega - S * b[i].omega).norm() > same * speed) return false;
    const Matrix3d turn_a = a.front().X.transpose() * a[i].X;
    const Matrix3d turn_b = b.front().X.transpose() * b[i].X;
    if (!turn_a.isApprox(S * turn_b * S.transpose(), same)) return false;
  }
  return true;
}

}  // namespace

bool are_same_motion(const Matrix3d& inertia, std::span<const Row> a, std::span<const Row> b) {
  return std::ranges::any_of(recording::all_body_axes(), [&](const BodyAxes& axes) {
    return are_equivalent(inertia, BodyAxes(), axes) && are_turned(a, b, axes.matrix());
  });
}

}  // namespace twrench::check

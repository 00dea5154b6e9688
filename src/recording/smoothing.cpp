#include "recording/smoothing.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace twrench::recording {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index order = 3;  // of the differences whose squares are the roughness

/// The weights of a divided difference, up to a factor.
VectorXd divided_difference(std::span<const double> times) {
  VectorXd weights = VectorXd::Ones(std::ssize(times));
  for (std::size_t i = 0; i < times.size(); ++i) {
    for (std::size_t k = 0; k < times.size(); ++k) {
      if (k != i) weights[static_cast<Index>(i)] /= times[i] - times[k];
    }
  }
  return weights;
}

/// The variance of each of three components that are independent from row to row, from differences
/// of `degree`.
double variance(const Sequence& sequence, std::size_t degree) {
  constexpr double median_of_squares = 2.366;  // of three normal numbers of variance 1
  std::vector<double> squares;
  for (std::size_t i = 0; i + degree < sequence.times.size(); ++i) {
    const VectorXd weights = divided_difference(sequence.times.subspan(i, degree + 1)).normalized();
    const auto rows = sequence.values.middleRows(static_cast<Index>(i), weights.size());
    squares.push_back((rows.transpose() * weights).squaredNorm());
  }
  const auto middle = squares.begin() + std::ssize(squares) / 2;
  std::ranges::nth_element(squares, middle);
  return *middle / median_of_squares;
}

/// The differences of the values as a matrix. They are those of unit spacing where the times are
/// equally spaced.
Eigen::SparseMatrix<double> differences(std::span<const double> times) {
  const Index rows = std::ssize(times) - order;
  const double spacing = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  Eigen::SparseMatrix<double> matrix(rows, std::ssize(times));
  matrix.reserve(Eigen::VectorXi::Constant(std::ssize(times), order + 1));
  for (Index i = 0; i < rows; ++i) {
    const auto window = times.subspan(static_cast<std::size_t>(i), order + 1);
    const VectorXd weights = divided_difference(window) * 6 * std::pow(spacing, order);
    for (Index k = 0; k <= order; ++k) matrix.insert(i, i + k) = weights[k];
  }
  return matrix;
}

}  // namespace

std::optional<double> independent_noise(const Sequence& sequence) {
  constexpr std::size_t fewest = 20;
  constexpr double alike = 1.3;  // ratio of two standard deviations
  if (sequence.times.size() < fewest) return std::nullopt;
  const double fourth = variance(sequence, 4), sixth = variance(sequence, 6);
  if (fourth > alike * alike * sixth || sixth > alike * alike * fourth) return std::nullopt;
  return std::sqrt(sixth);
}

MatrixXd smoothed(const Sequence& sequence, double noise) {
  // The smoothed values are y - D^T w, where (D D^T + m) w = D y. The smaller m, the smoother;
  // below the least value, where a hundred rows count, the rounding of w would show.
  constexpr double least = -12, greatest = 6;  // log10 of m
  constexpr int halvings = 14;
  const Eigen::SparseMatrix<double> D = differences(sequence.times);
  const Eigen::SparseMatrix<double> squared = D * D.transpose();
  const MatrixXd rough = D * sequence.values;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>
      solver;
  solver.analyzePattern(squared);
  const auto removed = [&](double logarithm) -> MatrixXd {
    solver.setShift(std::pow(10, logarithm));
    solver.factorize(squared);
    return D.transpose() * solver.solve(rough);
  };
  const double allowed = 3 * noise * noise * static_cast<double>(sequence.times.size());
  MatrixXd result = removed(least);
  double smooth = least, faithful = greatest;
  for (int i = 0; i < halvings && result.squaredNorm() > allowed; ++i) {
    const double middle = (smooth + faithful) / 2;
    (removed(middle).squaredNorm() > allowed ? smooth : faithful) = middle;
    if (i + 1 == halvings) result = removed(faithful);
  }
  return sequence.values - result;
}

}  // namespace twrench::recording

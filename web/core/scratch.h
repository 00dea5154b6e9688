#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace twrench::page {

/// The scratch area. A function of the core reads its arguments from the beginning of this area and
/// writes its results to the same place.
inline std::vector<double> numbers;

using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

inline Eigen::Vector3d vector_at(std::size_t i) { return Eigen::Vector3d(&numbers[i]); }
inline Eigen::Matrix3d matrix_at(std::size_t i) { return Eigen::Map<const RowMajor>(&numbers[i]); }

/// Reads arguments from the scratch area, one after another.
class Arguments {
 public:
  double number() { return numbers[next_++]; }
  std::size_t count() { return static_cast<std::size_t>(number()); }
  Eigen::Vector3d vector() {
    next_ += 3;
    return vector_at(next_ - 3);
  }
  Eigen::Matrix3d matrix() {
    next_ += 9;
    return matrix_at(next_ - 9);
  }

 private:
  std::size_t next_ = 0;
};

/// Writes results to the scratch area, one after another.
class Results {
 public:
  explicit Results(std::size_t count) {
    if (numbers.size() < count) numbers.resize(count);
  }
  Results& operator<<(double x) {
    if (next_ == numbers.size()) numbers.push_back(0);
    numbers[next_++] = x;
    return *this;
  }
  Results& operator<<(const Eigen::Vector3d& v) { return *this << v[0] << v[1] << v[2]; }
  Results& operator<<(const Eigen::Matrix3d& m) {
    for (int row = 0; row < 3; ++row) *this << Eigen::Vector3d(m.row(row).transpose());
    return *this;
  }
  Results& operator<<(const Eigen::Matrix4d& m) {
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) *this << m(row, column);
    }
    return *this;
  }
  /// An address in the core's memory.
  Results& operator<<(const void* place) {
    return *this << static_cast<double>(reinterpret_cast<std::uintptr_t>(place));
  }
  std::size_t count() const { return next_; }

 private:
  std::size_t next_ = 0;
};

}  // namespace twrench::page

#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace twrench::interchange {

/// An array of a .npz file.
struct NamedArray {
  std::string name;
  /// The sizes of a row; empty for one number a row.
  std::vector<std::size_t> row = {};
  /// The rows, one after the other.
  std::vector<double> numbers = {};
};

/// Returns the file that numpy.savez writes, except that its members have a fixed date: equal
/// arrays give equal files. Throws std::bad_alloc.
std::string npz_file(std::span<const NamedArray> arrays);

}  // namespace twrench::interchange

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "table/input.h"

namespace twrench::table {

/// A column of a NumPy file.
struct NpyColumn {
  std::string name;
  std::string type;         ///< as NumPy writes it: "<f8"
  std::uint64_t begin = 0;  ///< of the first number, in the file
  std::uint64_t step = 0;   ///< from one row to the next, bytes
};

/// Where the numbers of a NumPy file stand.
struct NpyHeader {
  std::vector<NpyColumn> columns;
  std::uint64_t rows = 0;
};

/// Reads the header of a NumPy file, versions 1 to 3: of an array with rows and columns, or of a
/// one-dimensional structured array. Sub-arrays and structures within are columns of their own:
/// "X[0][2]", "rates.x". Throws system::FileError for any other, for one with Python objects, and
/// where the file is shorter than the array.
NpyHeader read_npy_header(const Input& input);

}  // namespace twrench::table

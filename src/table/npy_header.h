#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
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

/// The layout of the numbers in a NumPy file.
struct NpyHeader {
  std::vector<NpyColumn> columns;
  std::uint64_t rows = 0;
};

/// Reads the header of a NumPy file, versions 1 to 3: of an array with rows and columns, or of a
/// one-dimensional structured array. Each element of a sub-array or nested structure is a separate
/// column: "X[0][2]", "rates.x". Throws system::FileError for any other array, for one with Python
/// objects, and if the file is shorter than the array.
NpyHeader read_npy_header(const Input& input);

/// Does the same for an array of any number of dimensions in an archive: `start` are the first
/// bytes of its file, which has `size` bytes. The first dimension counts the rows; the columns are
/// called "omega[0]" with the array's name. Nothing for arrays without dimensions or of Python
/// objects, which are no table. Throws if the size is not that of the shape.
std::optional<NpyHeader> read_npy_member(const Input& start, std::uint64_t size,
                                         const std::string& name);

}  // namespace twrench::table

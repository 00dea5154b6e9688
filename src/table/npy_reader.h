#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "table/input.h"
#include "table/npy_header.h"
#include "table/reader.h"

namespace twrench::table {

/// Reads a number of one of NumPy's types.
using NpyDecode = Number (*)(const char* bytes);

/// The function for the type of a column, "<f8". Throws BadTable if it is not read.
NpyDecode npy_decoder(const std::string& file, const NpyColumn& column);

/// The bytes of a number of the column.
std::size_t npy_size(const NpyColumn& column);

/// The rows of a NumPy array.
class NpyReader : public Reader {
 public:
  explicit NpyReader(Input input);

  void begin_pass(std::span<const std::size_t> columns) override;
  bool next(std::span<Number> numbers) override;
  std::string place() const override;

 private:
  struct Selected {
    NpyColumn column;
    std::size_t size;  ///< bytes of a number
    NpyDecode decode;
    std::size_t window;  ///< adjacent columns share one
  };

  Input input_;
  NpyHeader layout_;
  std::uint64_t row_ = 0;  ///< rows read
  std::vector<Selected> selected_;
  std::vector<Window> windows_;
};

}  // namespace twrench::table

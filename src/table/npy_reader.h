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

/// The rows of a NumPy array.
class NpyReader : public Reader {
 public:
  explicit NpyReader(Input input);

  void begin_pass(std::span<const std::size_t> columns) override;
  bool next(std::span<Number> numbers) override;
  std::string place() const override;

 private:
  using Decode = Number (*)(const char* bytes);

  struct Selected {
    NpyColumn column;
    std::size_t size;  ///< bytes of a number
    Decode decode;
    std::size_t window;  ///< adjacent columns share one
  };

  Input input_;
  NpyHeader layout_;
  std::uint64_t row_ = 0;  ///< rows read
  std::vector<Selected> selected_;
  std::vector<Window> windows_;
};

}  // namespace twrench::table

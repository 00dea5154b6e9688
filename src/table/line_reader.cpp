#include "table/line_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "system/error.h"

namespace twrench::table {
namespace {

constexpr std::size_t block_bytes = 1 << 18;

}  // namespace

std::size_t byte_order_mark(std::string_view text) {
  return text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
}

LineReader::LineReader(const Input& input) : input_(&input) {
  std::array<char, 3> first{};
  const std::size_t size = input.read(0, first.data(), first.size());
  offset_ = byte_order_mark({first.data(), size});
}

std::string LineReader::place() const { return fmt::format("{}:{}", input_->name(), number_); }

bool LineReader::refill() {
  const auto first = buffer_.begin();
  std::copy(first + static_cast<std::ptrdiff_t>(begin_), first + static_cast<std::ptrdiff_t>(end_),
            first);
  end_ -= begin_;
  begin_ = 0;
  buffer_.resize(end_ + block_bytes);
  const std::size_t got = input_->read(offset_, buffer_.data() + end_, block_bytes);
  offset_ += got;
  end_ += got;
  return got > 0;
}

bool LineReader::next(std::string_view& line) {
  std::size_t length = 0;
  bool has_end = false;
  while (true) {
    const std::string_view unread(buffer_.data() + begin_, end_ - begin_);
    const std::size_t found = unread.find('\n', length);
    has_end = found != std::string_view::npos;
    length = has_end ? found : unread.size();
    if (length > max_bytes) {
      ++number_;
      throw system::FileError(place(), fmt::format("the line is longer than {} bytes", max_bytes),
                              "a table has a line for each row");
    }
    if (has_end || !refill()) break;
  }
  if (!has_end && length == 0) return false;
  line = {buffer_.data() + begin_, length};
  begin_ += length + (has_end ? 1 : 0);
  ++number_;
  if (line.ends_with('\r')) line.remove_suffix(1);
  return true;
}

}  // namespace twrench::table

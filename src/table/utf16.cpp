#include "table/utf16.h"

#include <fmt/format.h>
#include <iconv.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "system/error.h"

namespace twrench::table {
namespace {

constexpr std::size_t mark_bytes = 2, converted_bytes = 1 << 18;

/// iconv's descriptor.
class Converter {
 public:
  explicit Converter(const char* from) : handle_(::iconv_open("UTF-8", from)) {}
  ~Converter() { ::iconv_close(handle_); }
  Converter(const Converter&) = delete;
  Converter& operator=(const Converter&) = delete;

  /// Appends the converted characters, and returns the number of bytes of `from` that they took.
  /// Sets errno to EILSEQ for an invalid character, and to EINVAL for one that continues.
  std::size_t append(std::string_view from, std::string& text) {
    std::vector<char> bytes(from.begin(), from.end());  // iconv takes no constant text
    char* in = bytes.data();
    std::size_t left = bytes.size();
    std::array<char, 4096> out{};
    int error = E2BIG;
    while (error == E2BIG) {
      char* to = out.data();
      std::size_t room = out.size();
      error = ::iconv(handle_, &in, &left, &to, &room) == static_cast<std::size_t>(-1) ? errno : 0;
      text.append(out.data(), out.size() - room);
    }
    errno = error;
    return from.size() - left;
  }

 private:
  iconv_t handle_;
};

}  // namespace

bool has_utf16_mark(std::string_view start) {
  using namespace std::string_view_literals;
  const bool is_utf32 = start.starts_with("\xFF\xFE\0\0"sv);
  return !is_utf32 && (start.starts_with("\xFF\xFE") || start.starts_with("\xFE\xFF"));
}

Input utf8_from_utf16(const Input& input) {
  std::vector<char> block(converted_bytes);
  input.read(0, block.data(), mark_bytes);
  Converter converter(block[0] == '\xFF' ? "UTF-16LE" : "UTF-16BE");
  auto text = std::make_shared<std::string>();
  std::uint64_t offset = mark_bytes;
  while (offset < input.size()) {
    const std::size_t size = input.read(offset, block.data(), block.size());
    const std::size_t taken = converter.append({block.data(), size}, *text);
    const int error = errno;
    const bool is_at_end = offset + size >= input.size();
    offset += taken;
    if (error == EILSEQ) {
      throw system::FileError(
          input.name(),
          fmt::format("its text in UTF-16 has an invalid character at byte {}", offset),
          "save it again as UTF-8");
    }
    if (error == EINVAL && is_at_end) {
      throw system::FileError(input.name(), "its text in UTF-16 ends within a character",
                              "it is cut off: copy it again");
    }
  }
  return {input.name(), std::move(text)};
}

}  // namespace twrench::table

#include "scene/fraction.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <charconv>
#include <optional>
#include <string_view>

namespace twrench::scene {
namespace {

/// The numbers up to which encoders keep a fraction exactly.
constexpr int most = 1'000'000;

std::optional<int> whole_number(std::string_view text) {
  int number = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_number = error == std::errc() && stop == text.data() + text.size();
  return is_number && number >= 1 && number <= most ? std::optional(number) : std::nullopt;
}

}  // namespace

double parse_fraction(const std::string& text, const std::string& what) {
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos) {
    const auto above = whole_number(std::string_view(text).substr(0, slash));
    const auto below = whole_number(std::string_view(text).substr(slash + 1));
    if (above && below) return static_cast<double>(*above) / *below;
  }
  throw InvalidArgument(what,
                        fmt::format("'{}' is not a fraction of whole numbers up to {}", text, most),
                        "give a number such as 25, or a fraction such as 30000/1001");
}

}  // namespace twrench::scene

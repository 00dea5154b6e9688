#include "app/arguments.h"

#include <fmt/format.h>

#include <charconv>

#include "base/error.h"

namespace twrench {
namespace {

std::vector<double> split(const std::string& text, char separator, const std::string& what) {
  std::vector<double> values;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    values.push_back(parse_number(text.substr(begin, end - begin), what));
    begin = end + 1;
  }
  return values;
}

}  // namespace

double parse_number(const std::string& text, const std::string& what) {
  const char* const end = text.data() + text.size();
  const char* begin = text.data();
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') ++begin;
  double value = 0.0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc{} || stop != end) {
    throw UsageError(what, fmt::format("'{}' is not a number", text));
  }
  return value;
}

std::vector<double> parse_numbers(const std::string& text, const std::string& what) {
  return split(text, ',', what);
}

Eigen::Vector3d parse_vector(const std::string& text, const std::string& what) {
  const std::vector<double> v = split(text, ',', what);
  if (v.size() == 3) return {v[0], v[1], v[2]};
  throw UsageError(what, fmt::format("'{}' is not three numbers with commas between", text));
}

Eigen::Vector2d parse_size(const std::string& text, const std::string& what) {
  const std::vector<double> v = split(text, 'x', what);
  if (v.size() == 2) return {v[0], v[1]};
  throw UsageError(what, fmt::format("'{}' is not WIDTHxHEIGHT", text));
}

}  // namespace twrench

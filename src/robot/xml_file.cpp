#include "robot/xml_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "base/words.h"
#include "system/file.h"
#include "system/file_kind.h"

namespace twrench::robot {
namespace {

constexpr std::size_t most_bytes = std::size_t{64} << 20U;
constexpr std::string_view white_space = " \t\r\n";

/// Readers visit nested elements recursively.
constexpr std::size_t most_nested = 200;

/// Returns half a unit of the last digit of a number.
double resolution_of(std::string_view digits) {
  const std::size_t letter = std::min(digits.find_first_of("eE"), digits.size());
  int exponent = 0;
  if (letter < digits.size()) {
    std::string_view power = digits.substr(letter + 1);
    if (power.starts_with('+')) power.remove_prefix(1);
    std::from_chars(power.data(), power.data() + power.size(), exponent);
  }
  const std::size_t point = digits.substr(0, letter).find('.');
  const auto decimals = point == std::string_view::npos ? 0 : static_cast<int>(letter - point - 1);
  return 0.5 * std::pow(10.0, exponent - decimals);
}

/// Returns the number that the whole word is; nothing if it is none.
std::optional<double> number_of(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0.0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (stop != word.data() + word.size() || word.empty()) return std::nullopt;
  if (error == std::errc::result_out_of_range) return std::nullopt;
  return value;
}

/// Returns an element that is nested too deeply; nothing if there is none.
pugi::xml_node nested_too_deeply(const pugi::xml_document& document) {
  std::size_t depth = 0;
  pugi::xml_node node = document;
  while (true) {
    if (depth > most_nested && node.type() == pugi::node_element) return node;
    if (node.first_child()) {
      node = node.first_child();
      ++depth;
      continue;
    }
    for (; !node.next_sibling(); --depth) {
      if (depth == 0) return {};
      node = node.parent();
    }
    node = node.next_sibling();
  }
}

std::string text_of_file(const std::filesystem::path& file) {
  const std::vector<std::uint8_t> bytes = system::read_regular_file(file, most_bytes);
  return {bytes.begin(), bytes.end()};
}

bool begins_like_xml(std::string_view text) {
  text = system::without_byte_order_mark(text);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '<';
}

std::string remedy_for(std::string_view word) {
  const std::size_t comma = word.find(',');
  if (comma == std::string_view::npos) return "write numbers such as 0.5 or 1e-3";
  std::string with_point(word);
  with_point[comma] = '.';
  return number_of(with_point) ? fmt::format("write {}", with_point)
                               : "separate numbers by blanks, not by commas";
}

}  // namespace

XmlFile::XmlFile(const std::filesystem::path& file) : XmlFile(text_of_file(file), file) {}

XmlFile::XmlFile(std::string text, const std::filesystem::path& file)
    : path_(file), text_(std::move(text)) {
  const std::string what = "cannot read " + file.string();
  if (const auto kind = system::recognized_file_kind(text_); kind && !begins_like_xml(text_)) {
    throw system::FileError(what, fmt::format("it is {}", *kind),
                            "give a robot description in URDF, SDF or MJCF, with text in UTF-8");
  }
  parsed_ = text_;
  // Entities other than the five of XML are not expanded, and nothing else is loaded.
  const pugi::xml_parse_result parsed = document_.load_buffer_inplace(
      parsed_.data(), parsed_.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!parsed) {
    throw system::FileError(what,
                            fmt::format("the XML document is cut off or damaged at byte {}: {}",
                                        parsed.offset, to_lower(parsed.description())),
                            "get the whole file, with text in UTF-8");
  }
  for (std::size_t i = 0; i < text_.size(); ++i)
    if (text_[i] == '\n') line_ends_.push_back(i);
  if (const pugi::xml_node node = nested_too_deeply(document_)) {
    throw bad(node, fmt::format("elements are nested more than {} deep", most_nested),
              "nest them less deeply");
  }
}

std::size_t XmlFile::line(const pugi::xml_node& node) const {
  const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0));
  return 1 + static_cast<std::size_t>(std::ranges::lower_bound(line_ends_, offset) -
                                      line_ends_.begin());
}

std::string XmlFile::place(const pugi::xml_node& node) const {
  return fmt::format("{}:{}: {}", path_.string(), line(node), node.name());
}

InvalidArgument XmlFile::bad(const pugi::xml_node& node, const std::string& why,
                             const std::string& remedy) const {
  return {place(node), why, remedy};
}

std::string_view XmlFile::required(const pugi::xml_node& node, const char* attribute) const {
  const pugi::xml_attribute found = node.attribute(attribute);
  if (!found) throw bad(node, fmt::format("it has no attribute '{}'", attribute), "add it");
  return found.value();
}

std::string_view XmlFile::written(const char* value) const {
  if (*value == '\0') return {};
  const auto begin = static_cast<std::size_t>(value - parsed_.data());
  const char before = text_[begin - 1];
  const std::string_view end = before == '>'   ? "<"
                               : before == '[' ? "]]>"
                               : before == '"' ? "\""
                                               : "'";
  return std::string_view(text_).substr(begin, text_.find(end, begin) - begin);
}

std::vector<Written> XmlFile::parse(const pugi::xml_node& node, const std::string& name,
                                    const char* value) const {
  std::vector<Written> numbers;
  const std::string_view text = written(value);
  std::size_t begin = text.find_first_not_of(white_space);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(white_space, begin), text.size());
    const std::string_view word = text.substr(begin, end - begin);
    const std::optional<double> number = number_of(word);
    if (!number) {
      throw bad(node, fmt::format("{} is '{}', which is not a number", name, word),
                remedy_for(word));
    }
    const auto at = static_cast<std::size_t>(word.data() - text_.data());
    numbers.push_back({*number, resolution_of(word), Span{at, word.size()}});
    begin = text.find_first_not_of(white_space, end);
  }
  return numbers;
}

std::vector<Written> XmlFile::exactly(std::vector<Written> numbers, const pugi::xml_node& node,
                                      const std::string& name, std::size_t count) const {
  if (numbers.size() == count) return numbers;
  throw bad(node, fmt::format("{} has {} numbers instead of {}", name, numbers.size(), count),
            "correct it");
}

std::vector<Written> XmlFile::numbers(const pugi::xml_node& node, const char* attribute,
                                      std::size_t count) const {
  if (!node.attribute(attribute)) return std::vector<Written>(count);
  return exactly(numbers(node, attribute), node, attribute, count);
}

std::vector<Written> XmlFile::numbers(const pugi::xml_node& node, std::size_t count) const {
  return exactly(parse(node, "its text", node.child_value()), node, "its text", count);
}

std::vector<Written> XmlFile::numbers(const pugi::xml_node& node, const char* attribute) const {
  const pugi::xml_attribute found = node.attribute(attribute);
  return found ? parse(node, attribute, found.value()) : std::vector<Written>();
}

std::optional<Eigen::Vector3d> XmlFile::vector(const pugi::xml_node& node,
                                               const char* attribute) const {
  if (!node.attribute(attribute)) return std::nullopt;
  const std::vector<Written> written = numbers(node, attribute, 3);
  const Eigen::Vector3d result(written[0].value, written[1].value, written[2].value);
  for (const double value : result) require_in_range(node, attribute, value);
  return result;
}

void XmlFile::require_in_range(const pugi::xml_node& node, const char* name, double number) const {
  if (!std::isfinite(number)) throw bad(node, fmt::format("{} is not finite", name));
  if (std::abs(number) <= largest_number) return;
  throw bad(node, fmt::format("{} is {}", name, number),
            fmt::format("give a number of at most {}", largest_number));
}

std::optional<double> XmlFile::number(const pugi::xml_node& node, const char* attribute) const {
  if (!node.attribute(attribute)) return std::nullopt;
  const double result = numbers(node, attribute, 1).front().value;
  require_in_range(node, attribute, result);
  return result;
}

std::optional<Span> XmlFile::span_of(const pugi::xml_node& node, const char* attribute) const {
  const pugi::xml_attribute found = node.attribute(attribute);
  if (!found) return std::nullopt;
  const auto name = static_cast<std::size_t>(found.name() - parsed_.data());
  const auto value = static_cast<std::size_t>(found.value() - parsed_.data());
  const std::size_t begin = text_.find_last_not_of(white_space, name - 1) + 1;
  const std::size_t end = text_.find(text_[value - 1], value) + 1;
  return Span{begin, end - begin};
}

}  // namespace twrench::robot

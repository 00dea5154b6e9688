#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/words.h"

// The names of enumerators, for enumerations whose values are 0, 1, 2 and so on. They are extracted
// from the function names that compilers generate, so that source code lists them only in the
// enumeration.

namespace twrench {
namespace detail {

/// Returns the name of the enumerator with this value, or text with a ')' if there is none. The
/// name of the function is "... [with auto value = twrench::scene::Frame::body; ...]" with GCC and
/// "... [value = twrench::scene::Frame::body]" with Clang; without an enumerator, both write
/// "(twrench::scene::Frame)3".
template <auto value>
consteval std::string_view source_name() {
  constexpr std::string_view start = "value = ";
  std::string_view text = __PRETTY_FUNCTION__;
  text.remove_prefix(text.find(start) + start.size());
  text = text.substr(0, text.find_first_of(";]"));
  return text.substr(text.rfind(':') + 1);
}

template <typename Enumeration, std::size_t from = 0>
consteval std::size_t enumerator_count() {
  constexpr auto value = static_cast<Enumeration>(from);
  if constexpr (source_name<value>().find(')') != std::string_view::npos) {
    return from;
  } else {
    return enumerator_count<Enumeration, from + 1>();
  }
}

/// Returns an array of the results of a function for 0, 1, 2 and so on.
template <std::size_t count>
consteval auto array_of(auto element) {
  return [&]<std::size_t... i>(std::index_sequence<i...> /*indices*/) {
    return std::array{element.template operator()<i>()...};
  }
  (std::make_index_sequence<count>());
}

template <typename Enumeration>
inline constexpr auto source_names = array_of<enumerator_count<Enumeration>()>([]<std::size_t i>() {
  return source_name<static_cast<Enumeration>(i)>();
});

}  // namespace detail

/// The enumerators, in order of declaration.
template <typename Enumeration>
inline constexpr auto enumerators = detail::array_of<detail::enumerator_count<Enumeration>()>(
    []<std::size_t i>() { return static_cast<Enumeration>(i); });

/// Returns the name of an enumerator as in the source code: "body".
template <typename Enumeration>
constexpr std::string_view enumerator_name(Enumeration value) {
  return detail::source_names<Enumeration>.at(static_cast<std::size_t>(value));
}

/// Returns the names of all enumerators, in order of declaration.
template <typename Enumeration>
std::vector<std::string> enumerator_names() {
  std::vector<std::string> names;
  for (const Enumeration value : enumerators<Enumeration>) {
    names.emplace_back(enumerator_name(value));
  }
  return names;
}

/// Returns the enumerator with that name. Throws InvalidArgument about `what`, suggesting the
/// nearest name.
template <typename Enumeration>
Enumeration find_enumerator(std::string_view name, const std::string& what) {
  const auto found =
      std::ranges::find(enumerators<Enumeration>, name, &enumerator_name<Enumeration>);
  if (found != enumerators<Enumeration>.end()) return *found;
  throw unknown_name(what, name, enumerator_names<Enumeration>());
}

/// Returns whether a table has one row per enumerator, in order of declaration. `key` is the member
/// of the rows that holds the enumerator. For static_assert beside the table.
template <typename Table, typename Row, typename Enumeration>
consteval bool has_row_for_each(const Table& table, Enumeration Row::*key) {
  return std::ranges::equal(table, enumerators<Enumeration>, {}, key);
}

}  // namespace twrench

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene/limits.h"

namespace twrench::scene {

/// The form of a value in TOML and in JSON, and its allowed values.
struct ValueForm {
  enum class Kind {
    number,      ///< A number.
    integer,     ///< A number without a fraction.
    rate,        ///< A number, or a string with the fraction of two whole numbers.
    vector,      ///< An array of three numbers.
    quaternion,  ///< An array of four numbers, the scalar first.
    size,        ///< An array of two integers: width and height.
    text,        ///< A string.
    texts,       ///< An array of strings.
    vectors,     ///< An array of arrays of three numbers.
    flag,        ///< true or false.
  };
  Kind kind = Kind::number;
  /// The limits of each number.
  std::optional<limits::Limit> limit = {};
  /// The allowed strings; empty if any string is allowed.
  std::vector<std::string> names = {};
  /// Whether a string may also be a colour, "#rrggbb" or "#rgb".
  bool is_color = false;
  /// The smallest and the largest number of strings or vectors in an array.
  std::size_t least = 0;
  std::optional<std::size_t> most = {};
};

}  // namespace twrench::scene

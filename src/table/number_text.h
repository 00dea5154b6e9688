#pragma once

#include <string_view>

#include "table/reader.h"

namespace twrench::table {

/// The result of reading a text as a number.
enum class Reading {
  number,     ///< in the range of doubles, or written as infinity or NaN
  too_large,  ///< a number beyond the range of doubles
  text        ///< not a number
};

/// Reads a whole text as a number, whatever the locale: with a sign, an exponent (e, E, and
/// Fortran's d, D), and a comma as decimal point if `decimal_comma` is set.
Reading read_number(std::string_view text, bool decimal_comma, Number& number);

/// Returns the text without blanks and tabs at its ends.
std::string_view trimmed(std::string_view text);

}  // namespace twrench::table

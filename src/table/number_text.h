#pragma once

#include <string_view>

#include "table/reader.h"

namespace twrench::table {

/// What a text is as a number.
enum class Reading {
  number,     ///< one that a double can hold, or what is written as infinite or NaN
  too_large,  ///< a number beyond all doubles
  text        ///< none
};

/// Reads a whole text as a number, whatever the locale: with a sign, an exponent (e, E, and
/// Fortran's d, D), and a comma for the point where `decimal_comma` says so.
Reading read_number(std::string_view text, bool decimal_comma, Number& number);

/// The text without blanks and tabs at its ends.
std::string_view trimmed(std::string_view text);

}  // namespace twrench::table

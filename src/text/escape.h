#pragma once

#include <string>
#include <string_view>

namespace twrench::text {

/// Returns the text on one line and safe for a terminal: control characters, invisible characters
/// that reorder or hide others, and invalid UTF-8 become \n, \x1b, \u202e. The result is for
/// display, not for parsing: backslashes stay as they are.
std::string escape(std::string_view text);

/// Replaces the characters of `markup`, which are some of the usual ones, by references, for the
/// content of XML or HTML and for an attribute's value in quotation marks.
std::string with_references(std::string_view text, std::string_view markup = "&<>\"");

/// Does both, so that the text has only characters that XML 1.0 allows.
std::string escape_xml(std::string_view text);

}  // namespace twrench::text

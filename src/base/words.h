#pragma once

#include <twrench/base/error.h>

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twrench {

/// Returns the text in lower case. Only A to Z are changed.
std::string to_lower(std::string_view text);

/// Returns the words of the text, which white space separates.
std::vector<std::string> words_of(const std::string& text);

/// Returns the candidate that `name` was most likely meant to be: the one with the fewest typing
/// errors (a letter inserted, omitted or changed, or two adjacent ones swapped), ignoring case. On
/// a tie the longest, because letters are omitted more often than inserted: "rk45" is "rkf45", not
/// "rk4"; then the first. Nothing if even that one is too different to be a misspelling.
std::optional<std::string> nearest(std::string_view name, std::span<const std::string> candidates);

/// Returns a list of names in quotation marks: "'a', 'b' and 'c'" or, if there are more,
/// "'a', 'b', 'c' and 57 others".
std::string list_of_names(std::span<const std::string> names);

/// Returns the error for a `name` that is not among `candidates`: "WHAT: unknown name 'NAME'", with
/// the nearest one suggested and all of them listed.
InvalidArgument unknown_name(const std::string& what, std::string_view name,
                             std::span<const std::string> candidates);

/// Returns how texts and errors of the libraries mention a value that users give. Each front end
/// words it in its own way: argument("units", "deg") is `--units deg` in the program and
/// units="deg" in Python. Without a value, the mention is of the argument itself.
std::string argument(std::string_view name, std::string_view value = {});

/// Words a mention of an argument.
using ArgumentWording = std::function<std::string(std::string_view name, std::string_view value)>;

/// Replaces the mentions of arguments in a text.
std::string with_arguments(std::string_view text, const ArgumentWording& wording);

}  // namespace twrench

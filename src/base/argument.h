#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace twrench {

/// Returns how texts and errors of the libraries mention a value that users give. Each front end
/// words it in its own way: argument("units", "deg") is `--units deg` in the program and
/// units="deg" in Python. Without a value, the mention is of the argument itself.
std::string argument(std::string_view name, std::string_view value = {});

/// Words a mention of an argument.
using ArgumentWording = std::function<std::string(std::string_view name, std::string_view value)>;

/// Replaces the mentions of arguments in a text.
std::string with_arguments(std::string_view text, const ArgumentWording& wording);

}  // namespace twrench

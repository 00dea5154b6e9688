#pragma once

#include <string>

namespace twrench {

/// Writes a command's data to the file, whole or not at all, or to standard output for "-".
/// Throws FileError.
void write_output(const std::string& path, const std::string& text);

}  // namespace twrench

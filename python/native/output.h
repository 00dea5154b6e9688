#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "system/output.h"

namespace twrench::python {

/// A file that a function of Python writes, checked against the files that it reads.
struct Output {
  system::FileList files;
  system::OutputFile file;
};

/// Throws InvalidArgument and OverwriteError as FileList::add_output() does. `format` may be empty.
Output make_output(const std::string& kind, const std::filesystem::path& file,
                   const std::vector<std::filesystem::path>& inputs, bool overwrite,
                   const std::string& format);

}  // namespace twrench::python

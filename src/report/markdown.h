#pragma once

#include <filesystem>

#include "report/document.h"
#include "report/html.h"

namespace twrench::report {

/// Writes the document as Markdown with TeX formulas, and its plots into SVG files beside it, whose
/// names begin with `stem`. Throws PlotError and FileError.
void write_markdown(const Document& document, const std::filesystem::path& folder,
                    const std::string& stem, const Write& write);

}  // namespace twrench::report

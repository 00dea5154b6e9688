#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "report/document.h"
#include "report/html.h"

namespace twrench::report {

/// Complete files of figures, which appear once they are committed.
using Figures = std::vector<std::unique_ptr<system::PendingFile>>;

/// Writes the document as Markdown with TeX formulas. Returns its plots as SVG files beside it,
/// whose names begin with `stem`; commit them once the document is written, so that either all of
/// it appears or nothing. Throws PlotError and FileError.
Figures write_markdown(const Document& document, const std::filesystem::path& folder,
                       const std::string& stem, const Write& write);

}  // namespace twrench::report

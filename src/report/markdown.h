#pragma once

#include <memory>
#include <vector>

#include "report/document.h"
#include "report/html.h"
#include "system/file_list.h"

namespace twrench::report {

/// The files of a document's figures, in their order.
using FigureFiles = std::vector<system::OutputFile>;

/// Returns files beside the report, and adds them to `files`. Throws OverwriteError.
FigureFiles files_of_figures(const Document& document, const system::OutputFile& report,
                             system::FileList& files);

/// Complete files of figures, which appear once they are committed.
using Figures = std::vector<std::unique_ptr<system::PendingFile>>;

/// Writes the document as Markdown with TeX formulas. Returns its plots as SVG files; commit them
/// once the document is written, so that either all of it appears or nothing. Throws PlotError and
/// FileError.
Figures write_markdown(const Document& document, const FigureFiles& files, const Write& write);

}  // namespace twrench::report

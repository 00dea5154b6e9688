#pragma once

#include "report/document.h"
#include "report/html.h"
#include "system/file_list.h"

namespace twrench::report {

/// Writes the document to a file, one of system::report_output. It appears complete, with all of
/// its figures, or not at all. The figures of Markdown are files beside it, which are added to
/// `files`. `viewer` is for HTML and may be null. Throws PlotError, OverwriteError and FileError.
void write_report(const system::OutputFile& file, const Document& document, const Viewer* viewer,
                  system::FileList& files);

}  // namespace twrench::report

#pragma once

#include <string>

#include "report/document.h"
#include "report/html.h"

namespace twrench::report {

/// Returns whether a report is Markdown rather than HTML, by the ending of its file; standard
/// output, "-", gets HTML. Throws InvalidArgument about any other ending.
bool is_markdown(const std::string& file);

/// Writes the document to a file, or to standard output for "-". It appears complete, with all of
/// its figures, or not at all. `viewer` is for HTML and may be null. Throws InvalidArgument as
/// is_markdown(), PlotError and FileError.
void write_report(const std::string& file, const Document& document, const Viewer* viewer);

}  // namespace twrench::report

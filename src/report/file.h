#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "report/document.h"
#include "system/output.h"

namespace twrench::report {

/// Receives the text of a report piece by piece.
using Write = std::function<void(std::string_view)>;

/// A page that is shown above the results.
struct Viewer {
  std::string page;    ///< A whole HTML document.
  std::string policy;  ///< The <meta> element of its content security policy.
  std::string poster;  ///< An <img> for print; may be empty.
};

/// Writes the document to a file, one of system::report_output. It appears complete, with all of
/// its figures, or not at all. The figures of Markdown are files beside it, which are added to
/// `files`. `viewer` is for HTML and may be null. Throws PlotError, OverwriteError and FileError.
void write_report(const system::OutputFile& file, const Document& document, const Viewer* viewer,
                  system::FileList& files);

/// Writes the document as a self-contained HTML file, with plots as SVG and formulas as MathML.
/// `viewer` may be null. Throws PlotError.
void write_html(const Document& document, const Viewer* viewer, const Write& write);

}  // namespace twrench::report

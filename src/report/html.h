#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "report/document.h"

namespace twrench::report {

/// Where a writer's text goes, piece by piece.
using Write = std::function<void(std::string_view)>;

/// A page to be looked at above the results.
struct Viewer {
  std::string page;    ///< A whole HTML document.
  std::string policy;  ///< The <meta> element of its content security policy.
  std::string poster;  ///< An <img> for paper; may be empty.
};

/// Writes the document as one HTML file that needs no other: plots as SVG, formulas as MathML.
/// `viewer` may be null. Throws PlotError.
void write_html(const Document& document, const Viewer* viewer, const Write& write);

}  // namespace twrench::report

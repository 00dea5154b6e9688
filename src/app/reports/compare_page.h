#pragma once

#include "app/terminal/output.h"
#include "comparison/comparison.h"

namespace twrench::app {

/// Writes a page of HTML that shows what was found, the worst frame first, with the expected image,
/// the actual one and their difference. It fetches nothing: style, script and pictures are in it;
/// pictures of as many frames as are useful to look at, and no more than a browser loads at once.
/// What has no picture is listed. Throws FileError.
void write_compare_page(const comparison::Comparison& comparison, Output& page);

}  // namespace twrench::app

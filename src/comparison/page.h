#pragma once

#include "comparison/comparison.h"
#include "comparison/report.h"

namespace twrench::comparison {

/// Writes a page of HTML that shows what was found, the worst frame first, with the expected image,
/// the actual one and their difference. It fetches nothing: style, script and pictures are in it;
/// pictures of as many frames as are useful to look at, and no more than a browser loads at once.
/// What has no picture is listed. Throws FileError, and what `write` throws.
void write_page(const Comparison& comparison, const Write& write);

}  // namespace twrench::comparison

#pragma once

#include "comparison/comparison.h"
#include "comparison/report.h"

namespace twrench::comparison {

/// Writes an HTML page that shows the results, the worst frame first, with the expected image, the
/// actual one and their difference. The page is self-contained: it embeds its style, script and
/// pictures. It has pictures of as many frames as are useful to look at, and no more than a browser
/// loads at once; the other frames are listed. Throws FileError, and whatever `write` throws.
void write_page(const Comparison& comparison, const Write& write);

}  // namespace twrench::comparison

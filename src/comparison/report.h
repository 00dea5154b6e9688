#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "comparison/comparison.h"

namespace twrench::comparison {

/// Receives a report piece by piece.
using Write = std::function<void(std::string_view)>;

/// Describes how much a frame differs: "max 30 mean 0.100000 of 255, 0.010000 of the pixels over
/// 0".
std::string difference_text(const FrameResult& frame, const Criteria& criteria);

/// Returns the notes of all frames, each once, with the number of frames that have it.
std::vector<std::string> notes_of(const Comparison& comparison);

/// Writes one line for two files, and a line for each note. For folders, writes a line for each
/// frame that is not as expected, a line for each note, and a summary.
void write_text(const Comparison& comparison, const Write& write);

/// Writes one JSON object with all frames.
void write_json(const Comparison& comparison, const Write& write);

/// Writes JUnit XML for continuous-integration servers: a test case for each frame.
void write_junit(const Comparison& comparison, const Write& write);

/// Writes an HTML page that shows the results, the worst frame first, with the expected image, the
/// actual one and their difference. The page is self-contained: it embeds its style, script and
/// pictures. It has pictures of as many frames as are useful to look at, and no more than a browser
/// loads at once; the other frames are listed. Throws FileError, and whatever `write` throws.
void write_page(const Comparison& comparison, const Write& write);

/// Returns an HTML figure that shows how much each frame of a film differs, on a logarithmic scale.
/// A bar for several frames shows the worst of them.
std::string difference_chart(const Comparison& comparison);

}  // namespace twrench::comparison

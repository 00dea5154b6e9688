#pragma once

namespace twrench {

/// Lets the memory of freed pictures of this size be kept for those to come: to give it back to the
/// system and to fetch it anew, page by page, takes a quarter of the time of a PNG frame.
void keep_memory_of_pictures(int width, int height);

}  // namespace twrench

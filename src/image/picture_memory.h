#pragma once

namespace twrench::image {

/// Keeps the memory of freed images of this size for later ones. Returning it to the system and
/// fetching it again page by page takes a quarter of the time of a PNG frame.
void keep_memory_of_pictures(int width, int height);

}  // namespace twrench::image

#include "image/picture_memory.h"

#include <malloc.h>

#include <algorithm>

namespace twrench::image {

void keep_memory_of_pictures(int width, int height) {
  const double picture = 3.0 * width * height;  // Bytes.
  const auto bytes = [](double count) { return static_cast<int>(std::clamp(count, 1e6, 1e9)); };
  // Blocks above the first threshold are mapped and unmapped individually; free memory beyond the
  // second at the end of the heap is returned, which keeps small pictures from accumulating memory.
  ::mallopt(M_MMAP_THRESHOLD, bytes(2 * picture));
  ::mallopt(M_TRIM_THRESHOLD, bytes(8 * picture));
}

}  // namespace twrench::image

#include "image/area.h"

#include <algorithm>

namespace twrench::image {
namespace {

long size(const Area& area) { return static_cast<long>(area.width) * area.height; }

}  // namespace

Area common(const Area& a, const Area& b) {
  const int x = std::max(a.x, b.x), y = std::max(a.y, b.y);
  return {x, y, std::max(std::min(a.x + a.width, b.x + b.width) - x, 0),
          std::max(std::min(a.y + a.height, b.y + b.height) - y, 0)};
}

Area around(const Area& a, const Area& b) {
  const int left = std::min(a.x, b.x), top = std::min(a.y, b.y);
  return {left, top, std::max(a.x + a.width, b.x + b.width) - left,
          std::max(a.y + a.height, b.y + b.height) - top};
}

std::vector<Area> merged(std::vector<Area> areas) {
  std::vector<Area> result;
  while (!areas.empty()) {
    const Area area = areas.back();
    areas.pop_back();
    const auto partner = std::ranges::find_if(result, [&](const Area& other) {
      return size(around(area, other)) <= size(area) + size(other);
    });
    if (partner == result.end()) {
      result.push_back(area);
    } else {
      areas.push_back(around(area, *partner));  // which may now overlap others
      result.erase(partner);
    }
  }
  return result;
}

}  // namespace twrench::image

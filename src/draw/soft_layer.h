#pragma once

#include <Eigen/Core>
#include <vector>

#include "image/area.h"
#include "image/image.h"

namespace twrench::draw {

/// A layer without sharp detail, at low resolution: a grid of cells whose colours are interpolated
/// between their centres when it is composited.
struct SoftLayer {
  /// Premultiplied red, green, blue and alpha, 0 to 255.
  using Cell = Eigen::Array4f;

  /// Number of cells across and down.
  int columns = 0, rows = 0;
  /// The cells, row by row from the top left.
  std::vector<Cell> cells;
  /// The top left corner of the grid, in pixels of the picture.
  Eigen::Array2d corner = {0, 0};
  /// Width and height of a cell in pixels.
  Eigen::Array2d cell_size = {1, 1};
  /// The pixels that it covers.
  image::Area covered;
};

/// Multiplies the layer's opacity by a factor from 0 to 1.
void scale_opacity(SoftLayer& layer, double factor);

/// Composites `layer` over `image`, which is RGB or premultiplied RGBA, with ordered dither. Pixels
/// on which the layer is transparent keep their values. The layer should lie inside the image;
/// parts outside are a bug of the caller and are clipped. Returns the affected areas.
std::vector<image::Area> composite_over(image::Image& image, const SoftLayer& layer);

}  // namespace twrench::draw

// edge_error REFERENCE DIR...: measures the antialiasing quality of the frames in each DIR. The
// frames in REFERENCE have the same names and four times the width and height, without
// antialiasing: the mean over 4 x 4 pixels is the correct value. Prints the mean absolute error, in
// steps of 1/255 of a channel, over the pixels that contain an edge: those whose sixteen samples
// differ by more than 32 in a channel.
#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <vector>

#include "image/png.h"

namespace twrench {
namespace {

namespace fs = std::filesystem;

constexpr int times = 4;
constexpr int contrast = 32;

struct Sums {
  double sum = 0;
  double squares = 0;
};

struct Block {
  double mean = 0;
  int spread = 0;
};

/// One channel of the reference's pixels for one pixel of a frame.
Block block(const image::Image& reference, int x, int y, int channel) {
  int sum = 0, low = 255, high = 0;
  for (int j = 0; j < times; ++j) {
    for (int i = 0; i < times; ++i) {
      const int value =
          reference.pixels[static_cast<std::size_t>(times * y + j) * reference.row_bytes() +
                           static_cast<std::size_t>(3 * (times * x + i) + channel)];
      sum += value;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  return {sum / double{times * times}, high - low};
}

void run(const fs::path& folder, const std::vector<fs::path>& others) {
  std::vector<Sums> errors(others.size());
  double count = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".png") continue;
    const image::Image reference = image::read_png(entry.path());
    std::vector<image::Image> images;
    for (const fs::path& other : others) {
      images.push_back(image::read_png(other / entry.path().filename()));
      if (images.back().width * times != reference.width || images.back().channels != 3 ||
          images.back().height * times != reference.height || reference.channels != 3) {
        throw InvalidArgument(other.string(),
                              "its frames are not a quarter of the reference's, RGB");
      }
    }
    for (int y = 0; y < reference.height / times; ++y) {
      for (int x = 0; x < reference.width / times; ++x) {
        const std::array channels{block(reference, x, y, 0), block(reference, x, y, 1),
                                  block(reference, x, y, 2)};
        if (std::ranges::max(channels, {}, &Block::spread).spread <= contrast) continue;
        ++count;
        for (std::size_t k = 0; k < images.size(); ++k) {
          for (std::size_t c = 0; c < 3; ++c) {
            const double value =
                images[k].pixels[static_cast<std::size_t>(y) * images[k].row_bytes() +
                                 3 * static_cast<std::size_t>(x) + c];
            const double error = std::abs(value - channels[c].mean);
            errors[k].sum += error;
            errors[k].squares += error * error;
          }
        }
      }
    }
  }
  fmt::print("{:.0f} pixels with an edge\n", count);
  for (std::size_t k = 0; k < others.size(); ++k) {
    fmt::print("{:<30} mean absolute error {:.3f}, root mean square {:.3f}\n",
               others[k].filename().string(), errors[k].sum / (3 * count),
               std::sqrt(errors[k].squares / (3 * count)));
  }
}

}  // namespace
}  // namespace twrench

int main(int argc, char** argv) try {
  if (argc < 3) {
    fmt::print(stderr, "usage: edge_error REFERENCE DIR...\n");
    return 2;
  }
  twrench::run(argv[1], {argv + 2, argv + argc});
} catch (const std::exception& error) {
  fmt::print(stderr, "edge_error: error: {}\n", error.what());
  return 1;
}

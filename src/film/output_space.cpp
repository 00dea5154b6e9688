#include "film/output_space.h"

#include <fmt/format.h>

#include "film/error.h"
#include "image/png.h"
#include "system/disk_space.h"

namespace twrench::film {
namespace {

/// Bytes, in floating point because the largest possible requests exceed integers.
struct Need {
  double frames = 0;
  double film = 0;
};

struct Shortage {
  std::filesystem::path path;
  double free;
  double needed;
};

/// Returns the first location with too little room, if any.
std::optional<Shortage> find_shortage(const PlannedOutput& output, const Need& need) {
  const bool shared = output.frames_folder && output.film &&
                      system::on_same_disk(*output.frames_folder, output.film->parent_path());
  if (output.frames_folder) {
    const auto free = static_cast<double>(system::free_space(*output.frames_folder));
    const double needed = need.frames + (shared ? need.film : 0);
    if (needed > free) return Shortage{*output.frames_folder, free, needed};
  }
  if (output.film) {
    const auto free = static_cast<double>(system::free_space(output.film->parent_path()));
    if (need.film > free) return Shortage{*output.film, free, need.film};
  }
  return std::nullopt;
}

}  // namespace

void require_space(const PlannedOutput& output, const std::function<image::Image()>& draw_one) {
  const auto new_frames = static_cast<double>(output.new_frames);
  const auto film_frames = static_cast<double>(output.film_frames);
  constexpr double png_bytes_a_pixel = 4.1;  // uncompressed RGBA with filter and block headers
  constexpr double film_bytes_a_pixel = 0.25;
  const Need bound{new_frames * output.frame_pixels * png_bytes_a_pixel,
                   film_frames * output.frame_pixels * film_bytes_a_pixel};
  if (!find_shortage(output, bound)) return;
  const auto png = static_cast<double>(image::encode_png(draw_one()).size());
  const Need estimate{1.25 * png * new_frames, 0.1 * png * film_frames};
  if (const auto shortage = find_shortage(output, estimate)) {
    throw SpaceError(
        "cannot write " + shortage->path.string(),
        fmt::format("{} are free, but the run needs an estimated {}",
                    system::format_bytes(shortage->free), system::format_bytes(shortage->needed)));
  }
}

}  // namespace twrench::film

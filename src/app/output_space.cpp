#include "app/output_space.h"

#include <fmt/format.h>

#include "base/disk_space.h"
#include "base/error.h"
#include "image/png.h"

namespace twrench {
namespace {

/// Bytes, as floating-point numbers because the largest that can be asked for are beyond integers.
struct Need {
  double frames = 0;
  double film = 0;
};

/// Where there is too little room for it, if anywhere.
std::optional<FileError> objection(const PlannedOutput& output, const Need& need) {
  const bool shared = output.frames_folder && output.film &&
                      on_same_disk(*output.frames_folder, output.film->parent_path());
  const auto check = [&](const std::filesystem::path& folder, double bytes,
                         const std::string& path) -> std::optional<FileError> {
    const auto free = static_cast<double>(free_space(folder));
    if (bytes <= free) return std::nullopt;
    return FileError("cannot write " + path,
                     fmt::format("{} are free there, and the run is estimated to need {}",
                                 format_bytes(free), format_bytes(bytes)),
                     "free some space, choose another disk, a smaller --size or fewer --frames");
  };
  if (output.frames_folder) {
    const double bytes = need.frames + (shared ? need.film : 0);
    if (auto error = check(*output.frames_folder, bytes, output.frames_folder->string())) {
      return error;
    }
  }
  if (output.film) return check(output.film->parent_path(), need.film, output.film->string());
  return std::nullopt;
}

}  // namespace

void require_space(const PlannedOutput& output, const std::function<Image()>& draw_one) {
  const auto new_frames = static_cast<double>(output.new_frames);
  const auto film_frames = static_cast<double>(output.film_frames);
  constexpr double png_bytes_a_pixel = 4.1;  // RGBA as it is, and the filter and block headers
  constexpr double film_bytes_a_pixel = 0.25;
  const Need bound{new_frames * output.frame_pixels * png_bytes_a_pixel,
                   film_frames * output.frame_pixels * film_bytes_a_pixel};
  if (!objection(output, bound)) return;
  const auto png = static_cast<double>(encode_png(draw_one()).size());
  const Need estimate{1.25 * png * new_frames, 0.1 * png * film_frames};
  if (const auto error = objection(output, estimate)) throw *error;
}

}  // namespace twrench

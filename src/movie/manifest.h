#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "movie/shard.h"

namespace twrench {

/// One frame as it was drawn. Matrices are for column vectors, row by row:
/// clip = projection * view * point, space coordinates to OpenGL clip space.
struct FrameRecord {
  int frame = 0;              ///< its number in the film
  double t = 0.0;             ///< s of motion
  std::array<double, 9> X{};  ///< the pose, space_from_body
  std::array<double, 16> view{};
  std::array<double, 16> projection{};
  std::string file;    ///< its name, in the manifest's folder
  std::string sha256;  ///< of the PNG file, 64 lower-case hexadecimal digits
};

/// What stands beside the frames of a film and says how they came to be.
// The destructor of nlohmann's json allocates. NOLINTNEXTLINE(bugprone-exception-escape)
struct Manifest {
  std::string version;           ///< of the program
  nlohmann::ordered_json scene;  ///< all values resolved
  std::string font{};            ///< digest of the typeface, as typeface_digest() gives it
  std::string renderer;          ///< the GL renderer string
  int width = 0;                 ///< pixels
  int height = 0;
  double fps = 0.0;                  ///< frames per second of film
  std::vector<std::string> encoder;  ///< ffmpeg's arguments: a record, never run from here
  std::string range;                 ///< the RANGE that was asked for; a stopped run has fewer
  Shard shard{};                     ///< the part of the range that this run draws
  std::vector<FrameRecord> frames;   ///< ascending by number
};

/// "frame_000012.png"
std::string frame_file_name(int frame);

/// Whether everything that determines the pixels of a frame is the same, its pose aside: program
/// version, scene, typeface, GL renderer and size.
bool same_film(const Manifest& a, const Manifest& b);

/// The manifest as JSON, a frame a line; every double is read back as the same double.
std::string format_manifest(const Manifest& manifest);

/// What stands in it before the frames, after all else.
inline constexpr std::string_view line_of_frames = "\n\"frames\": [";

/// That text, piece by piece, for a manifest too long to be held twice: its `count` frames are
/// those that `frame` gives, not its own.
void write_manifest(const Manifest& manifest, std::size_t count,
                    const std::function<FrameRecord(std::size_t)>& frame,
                    const std::function<void(std::string_view)>& write);

/// The manifest in the text, which may come from anyone. `name` names it in errors.
/// Throws FileError, with the place, for what is not a manifest: bad JSON, a missing or mistyped
/// value, a size, frame or fps out of bounds, frames out of order or not in the range, a file name
/// with a path in it.
Manifest parse_manifest(std::string_view text, const std::string& name);

/// The manifest in the file. Throws FileError when it cannot be read, and as parse_manifest.
Manifest read_manifest(const std::filesystem::path& path);

/// The manifest without its frames, of which, where format_manifest wrote it, no more is read than
/// what stands before them: a folder may have a thousand manifests of a thousand frames. Throws as
/// read_manifest.
Manifest read_manifest_head(const std::filesystem::path& path);

}  // namespace twrench

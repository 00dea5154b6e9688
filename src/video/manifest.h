#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "system/error.h"
#include "video/codec.h"
#include "video/frame_range.h"

namespace twrench::video {

/// The record of a frame. Matrices are for column vectors, in row-major order: clip = projection *
/// view * point, from space coordinates to OpenGL clip space.
struct FrameRecord {
  /// Frame number in the video.
  int frame = 0;
  /// Time of the motion in s.
  double t = 0.0;
  /// Index of the shot; 0 in a film without shots.
  int shot = 0;
  /// Number of flips of the body so far.
  int flips = 0;
  /// Time of the last flip in s; meaningless before the first flip.
  double last_flip = 0.0;
  /// The pose, space_from_body.
  std::array<double, 9> X{};
  /// View matrix.
  std::array<double, 16> view{};
  /// Projection matrix.
  std::array<double, 16> projection{};
  /// File name, in the manifest's folder.
  std::string file;
  /// SHA-256 of the PNG file, 64 lower-case hexadecimal digits.
  std::string sha256;
};

/// The manifest next to the frames of a video, which records how they were made.
// The destructor of nlohmann's json allocates. NOLINTNEXTLINE(bugprone-exception-escape)
struct Manifest {
  /// Version of the program.
  std::string version;
  /// The scene with all values resolved.
  nlohmann::ordered_json scene;
  /// Digest of the font, as returned by typeface_digest().
  std::string font{};
  /// The GL renderer string.
  std::string renderer;
  /// Size in pixels.
  int width = 0;
  /// Height in pixels.
  int height = 0;
  /// Frames per second of video.
  double fps = 0.0;
  /// ffmpeg's arguments, as a record; they are never executed from here.
  std::vector<std::string> encoder;
  /// The effort and the quality of the video; neither without a video, or if its codec has none.
  /// A record, which is not read back.
  Quality quality{};
  /// The requested RANGE; an interrupted run has fewer frames.
  std::string range;
  /// The part of the range that this run draws.
  Shard shard{};
  /// Ascending by number.
  std::vector<FrameRecord> frames;
};

/// Returns the file name of a frame, for example "frame_000012.png".
std::string frame_file_name(int frame);

/// Returns whether a run may write a file of this name in its folder of frames.
bool is_in_frames_folder(const std::string& name);

/// Returns whether the scene of a manifest, which may be of any form, has sound.
bool has_sound(const nlohmann::ordered_json& scene);

/// Returns the scene of a manifest as it would be without sound.
nlohmann::ordered_json without_sound(nlohmann::ordered_json scene);

/// Returns whether everything that determines the pixels of a frame, except its pose, is the same:
/// program version, scene except its sound, font, GL renderer and size.
bool same_film(const Manifest& a, const Manifest& b);

/// Returns whether the films are the same except for the contents of their mesh files.
bool same_but_for_meshes(const Manifest& a, const Manifest& b);

/// Returns the manifest as JSON with one frame per line; doubles survive the round trip exactly.
std::string format_manifest(const Manifest& manifest);

/// The text before the frames, after everything else.
inline constexpr std::string_view frames_marker = "\n\"frames\": [";

/// Writes the same text in pieces, for manifests too long to be in memory twice. The frames are the
/// `count` that `frame` returns, instead of those in `manifest`.
void write_manifest(const Manifest& manifest, std::size_t count,
                    const std::function<FrameRecord(std::size_t)>& frame,
                    const std::function<void(std::string_view)>& write);

/// Parses a manifest, which may come from an untrusted source. `name` names it in errors. Throws
/// FileError with the location if it is not a valid manifest: malformed JSON, a missing or mistyped
/// value, a size, frame or fps out of bounds, frames out of order or outside the range, or a file
/// name with a path.
Manifest parse_manifest(std::string_view text, const std::string& name);

/// Reads the manifest in the file. Throws FileError if it cannot be read, and as parse_manifest()
/// does.
Manifest read_manifest(const std::filesystem::path& path);

/// Reads the manifest without its frames. If format_manifest() wrote it, only the part before the
/// frames is read: a folder may contain a thousand manifests of a thousand frames. Throws as
/// read_manifest() does.
Manifest read_manifest_head(const std::filesystem::path& path);

/// Returns the manifests in a folder of frames, of the whole video and of shards, sorted by name.
/// Empty if there is no such folder. Throws FileError if it cannot be read.
std::vector<std::filesystem::path> manifests_in(const std::filesystem::path& folder);

/// Returns all manifests of the folder merged into one, whose range is the union of the requested
/// ranges. Throws FileError if there is none, if one is invalid, or if they disagree on the video
/// or on the digest of a frame.
Manifest read_manifests(const std::filesystem::path& folder);

}  // namespace twrench::video

#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "image/image.h"
#include "system/error.h"
#include "video/frame_sequence.h"

namespace twrench::film {

/// How a run treats existing frames.
enum class Reuse {
  none,       ///< Redraw frames of this video; do not touch others.
  resume,     ///< Keep intact frames of this video, and redraw frames whose meshes have
              ///< changed since; do not touch others.
  overwrite,  ///< Redraw any frames.
};

/// The folder to which a run writes its frames, and the frames that earlier runs left there.
class FramesOutput {
 public:
  /// Examines the folder without changing it. `film` is the manifest to be written, without frames
  /// but with the whole requested range; `frames` are the frames that this run draws. Throws
  /// ForeignFramesError if the run would overwrite frames that may belong to another film.
  FramesOutput(std::filesystem::path folder, video::Manifest film, std::vector<int> frames,
               Reuse reuse);

  /// Returns how many of the frames have no file yet.
  std::size_t count_without_file() const;

  /// Locks the folder, examines it again, because another run may have written there meanwhile, and
  /// begins to write. The manifest keeps its earlier records of the same video, so that a run
  /// killed at its start loses nothing; records of another video are dropped, like its frames.
  /// Throws FileError, and ForeignFramesError as the constructor does.
  video::FrameSequence& open();

  /// With Reuse::resume, keeps a frame that is intact and need not be drawn, and returns its
  /// record.
  std::optional<video::FrameRecord> kept(const video::FrameRecord& wanted);

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
  video::Manifest film_;
  std::vector<int> frames_;
  Reuse reuse_;
  video::EarlierRun earlier_;
  std::unique_ptr<video::FrameSequence> sequence_;  ///< Set by open().
};

/// The planned output of a run.
struct PlannedOutput {
  /// Folder of the frames; nothing if none are written.
  std::optional<std::filesystem::path> frames_folder;
  /// File of the video; nothing if none is written.
  std::optional<std::filesystem::path> film;
  /// Number of frames without a file yet.
  std::size_t new_frames = 0;
  /// Number of frames of the video.
  std::size_t film_frames = 0;
  /// Number of pixels of a frame.
  double frame_pixels = 0;
};

/// Throws SpaceError if the disk has too little space. First it checks for space for uncompressed
/// frames and a video of two bits per pixel, which there usually is. Only if there is not, it draws
/// a frame and estimates that every PNG is a quarter larger, and the video a tenth of the PNGs.
/// (Measured with the default scene: no frame is a quarter larger than the mean, and the video is a
/// fiftieth.)
void require_space(const PlannedOutput& output, const std::function<image::Image()>& draw_one);

}  // namespace twrench::film

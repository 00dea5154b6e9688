#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "comparison/picture_pair.h"
#include "image/area.h"
#include "image/compare.h"
#include "system/error.h"

namespace twrench::comparison {

/// Two folders whose frames are compared, or two files.
struct Inputs {
  std::filesystem::path expected, actual;
  /// Whether they are folders; the frames are then the files in them.
  bool folders = true;

  std::filesystem::path expected_frame(const std::string& name) const;
  std::filesystem::path actual_frame(const std::string& name) const;
};

/// A frame by its name, and which folders have it.
struct FrameName {
  std::string name;
  bool is_expected = true;
  bool is_actual = true;
};

/// Returns the frames of two folders, sorted by name. A frame is a file named *.png, also in
/// capital letters, that is not hidden; subfolders are ignored. A folder that does not exist has no
/// frames. Throws FileError if a folder cannot be read.
std::vector<FrameName> frames_of(const Inputs& folders);

/// The measure by which two frames are alike.
enum class Metric {
  share,  ///< The fraction of pixels that differ by more than a threshold.
  ssim,   ///< The structural similarity.
};

/// How frames are compared, and when two of them are alike.
struct Criteria {
  Metric metric = Metric::share;
  /// The largest difference of a channel, of 255, at which pixels count as equal.
  int threshold = 0;
  /// The largest fraction of pixels that may differ, 0 to 1.
  double share = 0.0;
  /// The least structural similarity, -1 to 1.
  double min_similarity = 1.0;
  /// By how many pixels edges may be displaced; see image::compare().
  int edges = 0;
  /// Areas whose pixels count as equal.
  std::vector<image::Area> ignored;
};

/// The result for a frame.
enum class Outcome {
  identical,     ///< The files have the same bytes.
  alike,         ///< The images differ within the criteria.
  different,     ///< They differ by more than the criteria allow.
  other_format,  ///< They differ in size or channels.
  missing,       ///< There is no actual frame.
  extra,         ///< There is no expected frame.
  unreadable,    ///< A file could not be read, or is not a complete PNG file.
};

/// A frame, and how it differs.
struct FrameResult {
  /// The name of the files.
  std::string name;
  Outcome outcome = Outcome::identical;
  /// Set for alike and different frames; zero for identical ones.
  image::Difference difference{};
  /// Set for the same frames, if the metric is the similarity.
  std::optional<double> similarity{};
  /// As PicturePair::notes().
  std::vector<std::string> notes{};
  /// The formats of the images, if these differ.
  std::string formats{};
  /// Why a frame is unreadable.
  std::shared_ptr<const system::FileError> failure{};

  /// Whether the frame is as expected.
  bool passed() const { return outcome == Outcome::identical || outcome == Outcome::alike; }
};

/// Returns how a frame differs from the expected one. Throws FileError as PicturePair does, and
/// InvalidArgument if an ignored area is not within the image, or an image is too small for its
/// structural similarity.
FrameResult compare_pictures(const PngFile& expected, const PngFile& actual,
                             const Criteria& criteria);

/// All frames of a comparison, in the order of their names.
struct Comparison {
  Inputs inputs;
  Criteria criteria;
  std::vector<FrameResult> frames;

  std::size_t count(Outcome outcome) const;
  bool passed() const;
  /// Returns the first frame that could not be read, or null.
  const FrameResult* first_unreadable() const;
};

/// Compares the frames of two folders on all processors; each processor holds one pair of frames at
/// a time. Files with the same bytes are not decoded, only checked for completeness. A frame that
/// cannot be read is among the results. `progress`, which may be empty, is called with the number
/// of frames done and the total, from one thread at a time. Throws FileError if a folder cannot be
/// read or neither has frames, and InvalidArgument as compare_pictures() does.
Comparison compare_folders(const Inputs& folders, const Criteria& criteria,
                           const std::function<void(int done, int total)>& progress);

/// A comparison of two files or two folders, with its outputs.
struct Request {
  /// Two files, or two folders of frames.
  std::filesystem::path expected, actual;
  Criteria criteria;
  /// The PNG file for the amplified difference of two files; or empty.
  std::string difference = {};
  /// The file for a page that shows what differs; or empty.
  std::string page = {};
  /// Whether the expected file or folder may be missing, because it will be updated.
  bool may_be_new = false;
  /// Whether the outputs may replace files of other kinds.
  bool overwrite = false;
};

/// Compares two files or folders, and writes the difference and the page. `progress` is as for
/// compare_folders(). Throws InvalidArgument if a file is compared with a folder, OverwriteError as
/// FileList does, and as compare_folders() and compare_pictures() do.
Comparison compare(const Request& request,
                   const std::function<void(int done, int total)>& progress);

/// Accepts the actual frames: copies those that are different, have another format or are extra
/// over the expected ones, each atomically, and returns their number. Frames that are alike or
/// missing remain unchanged. Copies nothing if a frame could not be read. Throws FileError, also if
/// another run writes to the folder.
std::size_t update_expected(const Comparison& comparison);

}  // namespace twrench::comparison

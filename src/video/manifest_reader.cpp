#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>

#include "image/png.h"
#include "system/error.h"
#include "system/file.h"
#include "video/frame_range.h"
#include "video/manifest.h"

namespace twrench::video {
namespace {

/// A value of a manifest and its path, such as "frames[3].X", for error messages. Refers to the
/// JSON, which must outlive it. The functions that read a value throw FileError if it has another
/// form.
class ManifestValue {
 public:
  /// `manifest` names the manifest in messages; `path` is empty for the whole of it.
  ManifestValue(const nlohmann::ordered_json& value, std::string manifest, std::string path);

  /// Throws FileError "cannot use MANIFEST: PATH must be EXPECTED".
  [[noreturn]] void fail(const std::string& expected) const;

  const nlohmann::ordered_json& value() const { return value_; }

  /// Returns the value of a key of an object.
  ManifestValue key(const char* name) const;
  /// Returns an item of an array, which must have that index.
  ManifestValue item(std::size_t index) const;
  std::size_t size_of_array() const;

  std::string text() const;
  /// A finite number.
  double number() const;
  int integer(int least, int most) const;
  /// An array of exactly N numbers.
  template <std::size_t N>
  std::array<double, N> numbers() const {
    const auto is_number = [](const nlohmann::ordered_json& item) { return item.is_number(); };
    if (!value_.is_array() || value_.size() != N ||
        !std::all_of(value_.begin(), value_.end(), is_number)) {
      fail(fmt::format("an array of {} numbers", N));
    }
    return value_.get<std::array<double, N>>();
  }

 private:
  const nlohmann::ordered_json& value_;
  std::string manifest_;
  std::string path_;
};

ManifestValue::ManifestValue(const nlohmann::ordered_json& value, std::string manifest,
                             std::string path)
    : value_(value), manifest_(std::move(manifest)), path_(std::move(path)) {}

void ManifestValue::fail(const std::string& expected) const {
  throw system::FileError("cannot use " + manifest_,
                          fmt::format("{} must be {}", path_.empty() ? "it" : path_, expected));
}

ManifestValue ManifestValue::key(const char* name) const {
  if (!value_.is_object() || !value_.contains(name))
    fail(fmt::format("an object with \"{}\"", name));
  return {value_[name], manifest_, path_.empty() ? name : path_ + "." + name};
}

ManifestValue ManifestValue::item(std::size_t index) const {
  return {value_[index], manifest_, fmt::format("{}[{}]", path_, index)};
}

std::size_t ManifestValue::size_of_array() const {
  if (!value_.is_array()) fail("an array");
  return value_.size();
}

std::string ManifestValue::text() const {
  if (!value_.is_string()) fail("a string");
  return value_.get<std::string>();
}

double ManifestValue::number() const {
  if (!value_.is_number() || !std::isfinite(value_.get<double>())) fail("a number");
  return value_.get<double>();
}

int ManifestValue::integer(int least, int most) const {
  const double number = value_.is_number_integer() ? value_.get<double>() : std::nan("");
  if (!(number >= least && number <= most)) {
    fail(fmt::format("an integer from {} to {}", least, most));
  }
  return static_cast<int>(number);
}

using Json = nlohmann::ordered_json;

std::string file_name(const ManifestValue& place) {
  std::string name = place.text();
  if (name.empty() || name == "." || name == ".." || name.find('/') != std::string::npos ||
      name.find('\0') != std::string::npos) {
    place.fail("a file name without a path");
  }
  return name;
}

std::string sha256(const ManifestValue& place) {
  std::string digest = place.text();
  const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  if (digest.size() != 64 || !std::all_of(digest.begin(), digest.end(), is_digit)) {
    place.fail("64 lower-case hexadecimal digits");
  }
  return digest;
}

/// Returns 0 for frames that older versions recorded without this key.
int count(const ManifestValue& place, const char* key) {
  return place.value().contains(key) ? place.key(key).integer(0, std::numeric_limits<int>::max())
                                     : 0;
}

/// The key is null before the first flip.
double last_flip(const ManifestValue& place) {
  return count(place, "flips") > 0 ? place.key("last_flip").number() : 0.0;
}

FrameRecord frame_record(const ManifestValue& place) {
  return {.frame = place.key("frame").integer(0, max_frame_count - 1),
          .t = place.key("t").number(),
          .shot = count(place, "shot"),
          .flips = count(place, "flips"),
          .last_flip = last_flip(place),
          .X = place.key("X").numbers<9>(),
          .view = place.key("view").numbers<16>(),
          .projection = place.key("projection").numbers<16>(),
          .file = file_name(place.key("file")),
          .sha256 = sha256(place.key("sha256"))};
}

/// The number of the line that contains the byte, starting at 1.
std::ptrdiff_t line_of(std::string_view text, std::size_t byte) {
  return 1 + std::ranges::count(text.substr(0, byte), '\n');
}

std::ptrdiff_t line_of(std::ifstream& text, std::size_t byte) {
  text.clear();
  text.seekg(0);
  std::ptrdiff_t line = 1;
  for (char c = 0; byte > 0 && text.get(c); --byte) line += c == '\n' ? 1 : 0;
  return line;
}

/// Parses a manifest's text as JSON, but extracts the frames as they are parsed: as JSON they would
/// take several times the memory of their text. The nesting depth is limited, because the rest is
/// traversed recursively.
template <typename Input>
Json parse_json(Input& text, const std::string& name, std::vector<FrameRecord>& frames) {
  constexpr int deepest = 32;
  bool in_frames = false;
  const auto take = [&](int depth, Json::parse_event_t event, Json& value) {
    if (depth > deepest) {
      throw system::FileError("cannot use " + name,
                              fmt::format("it is nested more than {} levels deep", deepest));
    }
    if (event == Json::parse_event_t::key && depth == 1) in_frames = value == "frames";
    const bool is_frame = in_frames && depth == 2 && event == Json::parse_event_t::object_end;
    if (is_frame) {
      frames.push_back(frame_record({value, name, fmt::format("frames[{}]", frames.size())}));
    }
    return !is_frame;
  };
  try {
    return Json::parse(text, take);
  } catch (const Json::parse_error& error) {
    throw system::FileError("cannot use " + name,
                            fmt::format("line {} is not valid JSON", line_of(text, error.byte)));
  } catch (const Json::exception&) {  // a number that no double can hold
    throw system::FileError("cannot use " + name, "it contains a number that is too large");
  }
}

/// Throws unless the frames belong to the range and are in ascending order. `place` holds the
/// remaining entries, which are not objects.
void check_frames(const std::vector<FrameRecord>& frames, const ManifestValue& place,
                  const std::string& range_text) {
  if (place.size_of_array() != 0) place.item(0).fail("an object");
  if (frames.empty()) return;  // only a head was read: its range may have a million frames
  const std::vector<int> range = parse_frame_range(range_text, max_frame_count);
  auto asked = range.begin();
  for (const FrameRecord& record : frames) {
    asked = std::find(asked, range.end(), record.frame);
    if (asked == range.end()) {
      place.fail(
          fmt::format("in ascending order and inside the range; frame {} is not", record.frame));
    }
    ++asked;
  }
}

/// Returns the range in the manifest, checked.
std::string frame_range(const ManifestValue& place) {
  std::string range = place.text();
  try {
    check_frame_range(range, max_frame_count);
  } catch (const InvalidArgument&) {
    place.fail("a range of frames");
  }
  return range;
}

Shard shard_of(const ManifestValue& root) {
  if (!root.value().contains("shard")) return {};
  const ManifestValue place = root.key("shard");
  try {
    return parse_shard(place.text());
  } catch (const InvalidArgument&) {
    place.fail("i/n");
  }
}

double positive(const ManifestValue& place) {
  const double number = place.number();
  if (number <= 0.0) {
    place.fail("positive");
  }
  return number;
}

std::vector<std::string> texts(const ManifestValue& place) {
  std::vector<std::string> result;
  const std::size_t size = place.size_of_array();
  for (std::size_t i = 0; i < size; ++i) result.push_back(place.item(i).text());
  return result;
}

/// Parses a manifest from a text or a stream.
template <typename Input>
Manifest parse(Input& text, const std::string& name) {
  std::vector<FrameRecord> frames;
  const Json json = parse_json(text, name, frames);
  const ManifestValue root(json, name, "");
  const ManifestValue size = root.key("size");
  if (size.size_of_array() != 2) {
    size.fail("[width, height]");
  }
  const std::string range = frame_range(root.key("range"));
  check_frames(frames, root.key("frames"), range);
  return {.version = root.key("version").text(),
          .scene = root.key("scene").value(),
          .font = root.value().contains("font") ? root.key("font").text() : "",
          .renderer = root.key("renderer").text(),
          .width = size.item(0).integer(1, image::max_image_side),
          .height = size.item(1).integer(1, image::max_image_side),
          .fps = positive(root.key("fps")),
          .encoder = texts(root.key("encoder")),
          .range = range,
          .shard = shard_of(root),
          .frames = std::move(frames)};
}

/// Throws if a line is so long that reading it could exhaust the memory. A line that we wrote has
/// one frame, or the scene.
void check_lines(std::ifstream& file, const std::string& name) {
  constexpr std::size_t longest = 1UL << 24U;
  std::vector<char> portion(1UL << 16U);
  std::size_t length = 0;
  while (file.read(portion.data(), std::ssize(portion)), file.gcount() > 0) {
    for (const char c : std::span(portion.data(), static_cast<std::size_t>(file.gcount()))) {
      length = c == '\n' ? 0 : length + 1;
      if (length <= longest) continue;
      throw system::FileError("cannot use " + name,
                              fmt::format("it contains a line of more than {} bytes", longest));
    }
  }
}

/// Rejects pipes, because opening one would wait for a writer.
std::ifstream open_manifest(const std::filesystem::path& path) {
  std::error_code failed;
  const auto status = std::filesystem::status(path, failed);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    throw system::FileError("cannot read " + path.string(), "it is not a regular file");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw system::file_error("cannot read " + path.string(), errno, system::Access::read);
  return file;
}

}  // namespace

Manifest parse_manifest(std::string_view text, const std::string& name) {
  return parse(text, name);
}

Manifest read_manifest(const std::filesystem::path& path) {
  std::ifstream file = open_manifest(path);
  check_lines(file, path.string());
  file.clear();
  file.seekg(0);
  return parse(file, path.string());
}

Manifest read_manifest_head(const std::filesystem::path& path) {
  std::ifstream file = open_manifest(path);
  constexpr std::size_t longest = 1UL << 24U;  // ten times a scene with the maximum number of parts
  constexpr std::size_t portion = 1UL << 14U;
  std::string head;
  for (std::size_t searched = 0; file && head.size() < longest;) {
    const std::size_t before = head.size();
    head.resize(before + portion);
    file.read(head.data() + before, portion);
    head.resize(before + static_cast<std::size_t>(file.gcount()));
    const std::size_t end = head.find(frames_marker, searched);
    if (end != std::string::npos) {
      head.resize(end + frames_marker.size());
      return parse_manifest(head + "]}", path.string());
    }
    searched = head.size() - std::min(head.size(), frames_marker.size());
  }
  Manifest manifest = read_manifest(path);
  manifest.frames.clear();
  return manifest;
}

}  // namespace twrench::video

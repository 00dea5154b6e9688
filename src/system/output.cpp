#include "system/output.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <twrench/base/error.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <set>
#include <system_error>

#include "base/words.h"
#include "system/file.h"

namespace twrench::system {
namespace {

using namespace std::string_view_literals;
constexpr std::string_view scene_first = "{\n \"scene\": ";

constexpr std::array motion_formats{
    OutputFormat{"csv", {".csv"}, "t,x11,x12,x13,x21,x22,x23,", ",wx,wy,wz,energy"},
    OutputFormat{"json", {".json"}, scene_first, "\n \"samples\": ["},
    OutputFormat{"npz", {".npz"}, "PK\x03\x04", "orthogonality_error.npy", true}};

constexpr std::array saved_motion_formats{motion_formats[0], motion_formats[2]};

constexpr std::array exported_motion_formats{
    OutputFormat{"glb", {".glb"}, "glTF", "\"generator\":\"twrench ", true},
    OutputFormat{"py", {".py"}, "# Written by twrench ", "as an animation for Blender"},
    OutputFormat{"aem", {".aem"}, "CCSDS_AEM_VERS = ", "COMMENT Written by twrench "},
    motion_formats[0],
    motion_formats[1],
    motion_formats[2]};

constexpr std::array inertia_formats{
    OutputFormat{"text", {".txt"}, "", "\nprincipal axes as columns, in body axes\n"},
    OutputFormat{"json", {".json"}, scene_first, "\n \"principal_moments\": ["},
    OutputFormat{"junit", {".xml"}, "<?xml", "<testsuites name=\"twrench inertia\""}};

constexpr std::array robot_formats{
    OutputFormat{"text", {".txt"}, "", "  principal moments, kg m^2  "},
    OutputFormat{"json", {".json"}, "{\n \"robot\"", "\n \"counts\": {"},
    OutputFormat{"junit", {".xml"}, "<?xml", "<testsuites name=\"twrench inertia\""}};

constexpr std::array robot_page_formats{OutputFormat{
    "html", {".html"}, "<!doctype html>", "name=\"generator\" content=\"twrench inertia\">"}};

// A repaired file has no mark of twrench, because it differs from the original only in numbers.
constexpr std::string_view no_mark = "\x01";
constexpr std::array robot_file_formats{OutputFormat{"urdf", {".urdf", ".xml"}, "", no_mark},
                                        OutputFormat{"sdf", {".sdf", ".world"}, "", no_mark},
                                        OutputFormat{"mjcf", {".xml", ".mjcf"}, "", no_mark}};

constexpr std::array check_formats{
    OutputFormat{"text", {".txt"}, "", "\n  read as         "},
    OutputFormat{"json", {".json"}, "{\n \"file", "\"rows\": "},
    OutputFormat{"junit", {".xml"}, "<?xml", "<testsuites name=\"twrench check\""}};

constexpr std::array study_formats{
    OutputFormat{"text", {".txt"}, "", " s of motion, methods compared with "},
    OutputFormat{"csv", {".csv"}, "method,order_seen,step,tolerance,", "estimate_median_ratio"},
    OutputFormat{"json", {".json"}, scene_first, "\n \"reference\": "}};

constexpr std::array case_list_formats{
    OutputFormat{"text", {".txt"}, "name  ", "basilisk-spacecraft"},
    OutputFormat{"json", {".json"}, "{\n \"cases\": [", "basilisk-spacecraft"},
    OutputFormat{"csv", {".csv"}, "name,I1,I2,I3,inertia_unit,", "basilisk-spacecraft"}};

constexpr std::array case_formats{
    OutputFormat{"text", {".txt"}, "case      ", "\nsource    "},
    OutputFormat{"json", {".json"}, "{\n \"name\": ", "\n \"published\": "},
    OutputFormat{"csv", {".csv"}, "t,wx,wy,wz,qw,qx,qy,qz,energy,Lx,Ly,Lz\n", ""}};

constexpr std::array schema_formats{
    OutputFormat{"json", {".json"}, "{", "\"title\": \"Scene file of twrench\""}};

constexpr std::array plot_formats{
    OutputFormat{"svg", {".svg"}, "<?xml", "<!-- twrench -->"},
    OutputFormat{"pdf", {".pdf"}, "%PDF", "%twrench\n", true},
    OutputFormat{"png", {".png"}, "\x89PNG", "tEXtSoftware\0twrench"sv, true}};

constexpr std::array picture_formats{plot_formats[2]};

constexpr std::array page_formats{OutputFormat{
    "html", {".html", ".htm"}, "<!doctype html>", "name=\"generator\" content=\"twrench\">"}};

constexpr std::array index_formats{
    OutputFormat{"html", {".html"}, "<!DOCTYPE html>", page_formats[0].mark}};

constexpr std::array report_formats{
    OutputFormat{"html", {".html"}, "<!doctype html>", "name=\"generator\" content=\"twrench "},
    OutputFormat{"markdown", {".md"}, "# ", "\n    twrench report "}};

constexpr std::array comparison_formats{OutputFormat{
    "html", {".html"}, "<!doctype html>", "name=\"generator\" content=\"twrench compare\">"}};

bool has_ending(const OutputFormat& format, std::string_view ending) {
  return std::ranges::find(format.endings, ending) != format.endings.end();
}

/// "A, B or C", of a text of each format.
std::string alternatives(const OutputKind& kind, const auto& text_of) {
  std::string text;
  for (std::size_t i = 0; i < kind.formats.size(); ++i) {
    if (i > 0) text += i + 1 < kind.formats.size() ? ", " : " or ";
    text += text_of(kind.formats[i]);
  }
  return text;
}

/// The beginning and the end of a file, where its mark is.
std::string ends_of(const std::filesystem::path& file) {
  constexpr std::streamsize head = 1 << 16, tail = 1 << 10;
  std::ifstream stream(file, std::ios::binary);
  std::string text(static_cast<std::size_t>(head + tail), '\0');
  stream.read(text.data(), head);
  std::streamsize size = stream.gcount();
  if (stream) {
    stream.seekg(-tail, std::ios::end);
    stream.read(text.data() + size, tail);
    size += stream.gcount();
  }
  text.resize(static_cast<std::size_t>(size));
  return text;
}

}  // namespace

const OutputKind motion_output{"trajectory", motion_formats};

const OutputKind saved_motion{"motion", saved_motion_formats, OutputKind::Choice::files_only};

const OutputKind exported_motion{"export", exported_motion_formats, OutputKind::Choice::by_name};

const OutputKind inertia_output{"inertia", inertia_formats};

const OutputKind robot_output{"inertia", robot_formats};

const OutputKind robot_page{"robot report", robot_page_formats, OutputKind::Choice::files_only};

const OutputKind robot_file{"repaired robot", robot_file_formats, OutputKind::Choice::files_only};

const OutputKind check_output{"check", check_formats};

const OutputKind study_output{"study", study_formats};

const OutputKind list_of_cases{"cases", case_list_formats};

const OutputKind case_output{"case", case_formats};

const OutputKind schema_output{"schema", schema_formats};

const OutputKind plot_output{"plot", plot_formats, OutputKind::Choice::files_only};

const OutputKind page_output{"page", page_formats};

const OutputKind index_output{"index", index_formats};

const OutputKind report_output{"report", report_formats, OutputKind::Choice::by_ending};

const OutputKind comparison_page{"comparison", comparison_formats, OutputKind::Choice::files_only};

const OutputKind difference_picture{"difference", picture_formats, OutputKind::Choice::files_only};

std::string listed_endings(const OutputKind& kind) {
  return alternatives(kind, [](const OutputFormat& format) { return format.endings[0]; });
}

std::string listed_names(const OutputKind& kind) {
  return alternatives(kind, [](const OutputFormat& format) { return format.name; });
}

const OutputFormat& format_of(const OutputKind& kind, const std::filesystem::path& file,
                              std::string_view name) {
  using Choice = OutputKind::Choice;
  const bool is_stream = file == "-";
  const std::string ending = is_stream ? std::string() : to_lower(file.extension().string());
  const std::string what = fmt::format("{} {}", kind.name, file.string());
  const auto named = std::ranges::find(kind.formats, name, &OutputFormat::name);
  if (named != kind.formats.end()) {
    if (ending.empty() || has_ending(*named, ending)) return *named;
    throw InvalidArgument(
        what,
        fmt::format("its name must end in {}, because the format is {}", named->endings[0], name),
        "choose another name, or leave out the format");
  }
  if (!name.empty()) {
    std::vector<std::string> names;
    for (const OutputFormat& format : kind.formats) names.emplace_back(format.name);
    throw unknown_name(argument("format"), name, names);
  }
  if (ending.empty() && kind.choice == Choice::by_default) return kind.formats.front();
  if (is_stream && kind.choice == Choice::by_ending) return kind.formats.front();
  for (const OutputFormat& format : kind.formats) {
    if (!ending.empty() && has_ending(format, ending)) return format;
  }
  if (is_stream && kind.choice == Choice::by_name) {
    throw InvalidArgument(argument("format"),
                          "is needed for standard output, which has no file extension",
                          "give " + listed_names(kind));
  }
  const std::string last = file.filename().string();
  for (const OutputFormat& format : kind.formats) {
    if (!last.empty() && has_ending(format, last)) {
      throw InvalidArgument(what, "there is no name before the ending",
                            "name a file, such as out" + last);
    }
  }
  throw InvalidArgument(
      what, "its name must end in " + listed_endings(kind),
      kind.choice == Choice::by_name
          ? "choose another name, or the format: " + argument("format") + " " + listed_names(kind)
          : "choose another name");
}

bool is_written_in(const OutputFormat& format, const std::filesystem::path& file) {
  const std::string text = ends_of(file);
  return text.starts_with(format.begins) && text.find(format.mark) != std::string::npos;
}

namespace {

namespace fs = std::filesystem;

/// The absolute path without links in its folders; its last component may be one.
fs::path place_of(const fs::path& path) {
  std::error_code unknown;
  fs::path place = fs::absolute(path, unknown).lexically_normal();
  if (!place.has_filename()) place = place.parent_path();  // "folder/" is "folder"
  return fs::weakly_canonical(place.parent_path(), unknown) / place.filename();
}

/// Names that identify the file, which need not exist: its place, that of the link's target, and
/// its number. A device has none.
std::set<std::string> identities_of(const fs::path& path) {
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (exists && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)) return {};
  std::set<std::string> names{place_of(path).string(), place_of(link_target(path)).string()};
  if (exists) names.insert(fmt::format("{}:{}", status.st_dev, status.st_ino));
  return names;
}

/// Throws if a new file cannot be put beside the file, so that a command fails before its
/// computation. Devices need no new file. A missing folder may be created later.
void require_place_for(const fs::path& file) {
  std::error_code unknown;
  const fs::path target = link_target(file);
  if (fs::exists(target, unknown) && !fs::is_regular_file(target, unknown)) return;
  const fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
  if (!fs::is_directory(folder, unknown)) return;
  if (::faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0) {
    throw file_error("cannot write " + file.string(), errno);
  }
}

[[noreturn]] void refuse_input(const fs::path& output) {
  throw OverwriteError(output.string(), "it is an input of this command and would be overwritten",
                       "choose another name for the output");
}

[[noreturn]] void refuse_second_output(const fs::path& output) {
  throw OverwriteError(output.string(), "two outputs of this command would be written to this file",
                       "choose another name for one of them");
}

}  // namespace

void FileList::add_input(const fs::path& file) {
  std::error_code unknown;
  if (!file.empty() && file != "-" && fs::exists(file, unknown)) add(file, Role::input);
}

void FileList::add_output(const fs::path& file) {
  if (!file.empty() && file != "-") add(file, Role::output);
}

OutputFile FileList::add_output(const OutputKind& kind, const fs::path& file,
                                std::string_view format) {
  add_output(file);
  const OutputFormat& chosen = format_of(kind, file, format);
  std::error_code unknown;
  const bool is_stream = file == "-" || is_named_descriptor(link_target(file));
  const bool stands =
      !is_stream && fs::is_regular_file(file, unknown) && fs::file_size(file, unknown) > 0;
  if (stands && !overwrite_ && !is_written_in(chosen, file)) {
    throw ExistingFileError(
        file.string(),
        fmt::format("it exists, and is not {} output of twrench ({})", kind.name, chosen.name));
  }
  if (!is_stream) require_place_for(file);
  return {file, chosen};
}

void FileList::add_outputs(const fs::path& folder,
                           std::function<bool(const std::string& name)> is_output) {
  add_output(folder);
  const std::string place = place_of(link_target(folder)).string();
  for (const auto& [name, entry] : files_) {
    const fs::path path = name;
    if (path.parent_path() != place || !is_output(path.filename().string())) continue;
    entry.role == Role::input ? refuse_input(entry.path) : refuse_second_output(entry.path);
  }
  folders_.push_back({place, std::move(is_output)});
}

void FileList::add(const fs::path& file, Role role) {
  const auto refuse = [&](Role other, const fs::path& output) {
    role == Role::input || other == Role::input ? refuse_input(output)
                                                : refuse_second_output(output);
  };
  for (const std::string& name : identities_of(file)) {
    const auto [entry, is_new] = files_.try_emplace(name, Entry{file, role});
    const bool clashes = role == Role::output || entry->second.role == Role::output;
    if (!is_new && clashes)
      refuse(entry->second.role, role == Role::output ? file : entry->second.path);
    const fs::path path = name;
    for (const Folder& folder : folders_) {
      if (path.parent_path() == folder.place && folder.is_output(path.filename().string())) {
        refuse(Role::output, file);
      }
    }
  }
}

namespace {

[[noreturn]] void fail_to_write() {
  const char* const what = "cannot write standard output";
  if (errno == EPIPE) throw ClosedPipe(what, "its reader has ended");
  throw file_error(what, errno);
}

}  // namespace

Output::Output(const OutputFile& file) {
  if (file.path() != "-") file_.emplace(file.path());
}

void Output::write(std::string_view text) {
  constexpr std::size_t enough = 1 << 16;
  waiting_ += text;
  if (waiting_.size() >= enough) pass_on();
}

void Output::finish() {
  pass_on();
  if (file_) return file_->commit();
  if (std::fflush(stdout) != 0) fail_to_write();
}

void Output::pass_on() {
  if (file_) {
    file_->write({reinterpret_cast<const std::uint8_t*>(waiting_.data()), waiting_.size()});
  } else if (std::fwrite(waiting_.data(), 1, waiting_.size(), stdout) != waiting_.size()) {
    fail_to_write();
  }
  waiting_.clear();
}

void write_output(const OutputFile& file, std::string_view text) {
  Output output(file);
  output.write(text);
  output.finish();
}

void write_output(std::string_view text) {
  Output output;
  output.write(text);
  output.finish();
}

}  // namespace twrench::system

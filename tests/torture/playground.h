#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace twrench::torture {

/// A command that wrote the files "own_COMMAND.ENDING" of the playground.
struct Writing {
  std::vector<std::string> words;
  std::vector<std::string> endings;

  const std::string& command() const { return words.front(); }
};

const std::vector<Writing>& writings();

/// Fills the empty folder with files for command lines: valid and broken scenes, pictures and
/// folders of frames, outputs of `twrench` and of other programs under each ending, links, and
/// names that are hard to print. `twrench` draws the frames. Throws std::runtime_error on failure.
void furnish(const std::filesystem::path& folder, const std::filesystem::path& twrench);

/// Copies such a folder, and adds what cannot be copied: FIFOs, and inaccessible entries.
void copy_playground(const std::filesystem::path& from, const std::filesystem::path& to);

/// Creates a folder with an ffmpeg and an ffprobe that print a warning and then run those later in
/// PATH.
void put_loud_programs(const std::filesystem::path& folder);

}  // namespace twrench::torture

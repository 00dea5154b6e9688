#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "scratch_folder.h"
#include "system/file.h"

namespace twrench::video {

/// Sets PATH during its lifetime.
class PathSetting {
 public:
  explicit PathSetting(const std::string& path) { setenv("PATH", path.c_str(), 1); }
  ~PathSetting() { setenv("PATH", before_.c_str(), 1); }
  PathSetting(const PathSetting&) = delete;
  PathSetting& operator=(const PathSetting&) = delete;

  static std::string current() {
    const char* path = std::getenv("PATH");
    return path != nullptr ? path : "";
  }

 private:
  const std::string before_ = current();
};

/// Puts a substitute ffmpeg, a shell script, first in PATH during its lifetime.
class StubFfmpeg {
 public:
  StubFfmpeg(const ScratchFolder& scratch, const std::string& script)
      : path_((scratch / "bin").string() + ":" + PathSetting::current()) {
    std::filesystem::create_directories(scratch / "bin");
    system::write_file_atomically(scratch / "bin/ffmpeg", std::string_view("#!/bin/sh\n" + script));
    std::filesystem::permissions(scratch / "bin/ffmpeg", std::filesystem::perms::owner_all);
  }

 private:
  PathSetting path_;
};

}  // namespace twrench::video

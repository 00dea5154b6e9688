#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/file.h"
#include "scratch_folder.h"

namespace twrench {

/// An ffmpeg of the test's own before the real one in PATH, a shell script; while it lives.
class StubFfmpeg {
 public:
  explicit StubFfmpeg(const ScratchFolder& scratch, const std::string& script)
      : path_(std::getenv("PATH")) {
    const std::filesystem::path folder = scratch / "bin";
    std::filesystem::create_directories(folder);
    write_file_atomically(folder / "ffmpeg", std::string_view("#!/bin/sh\n" + script));
    std::filesystem::permissions(folder / "ffmpeg", std::filesystem::perms::owner_all);
    setenv("PATH", (folder.string() + ":" + path_).c_str(), 1);
  }
  ~StubFfmpeg() { setenv("PATH", path_.c_str(), 1); }
  StubFfmpeg(const StubFfmpeg&) = delete;
  StubFfmpeg& operator=(const StubFfmpeg&) = delete;

 private:
  std::string path_;
};

/// A PATH in which there is nothing; while it lives.
class EmptyPath {
 public:
  explicit EmptyPath(const ScratchFolder& scratch) : path_(std::getenv("PATH")) {
    setenv("PATH", scratch.path().c_str(), 1);
  }
  ~EmptyPath() { setenv("PATH", path_.c_str(), 1); }
  EmptyPath(const EmptyPath&) = delete;
  EmptyPath& operator=(const EmptyPath&) = delete;

 private:
  std::string path_;
};

}  // namespace twrench

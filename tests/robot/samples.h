#pragma once

#include <gtest/gtest.h>
#include <twrench/base/error.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "robot/robot.h"
#include "scratch_folder.h"

namespace twrench::robot {

/// A file in a folder of its own.
class RobotFile {
 public:
  explicit RobotFile(const std::string& text, const std::string& name = "robot.urdf")
      : path_(folder_.path() / name) {
    std::ofstream(path_, std::ios::binary) << text;
  }

  const std::filesystem::path& path() const { return path_; }
  const std::filesystem::path& folder() const { return folder_.path(); }
  Robot read() const { return read_robot(path_); }

  /// Returns the exit code and the message with which the file is rejected, without its folder, or
  /// "nothing" if it is accepted.
  std::string refusal() const {
    std::string message = "nothing";
    try {
      read();
    } catch (const InvalidArgument& error) {
      message = std::string("2 ") + error.what() + "; " + error.remedy();
    } catch (const system::FileError& error) {
      message = std::string("5 ") + error.what() + "; " + error.remedy();
    }
    const std::string folder = folder_.path().string() + "/";
    const std::size_t found = message.find(folder);
    return found == std::string::npos ? message : message.erase(found, folder.size());
  }

 private:
  ScratchFolder folder_;
  std::filesystem::path path_;
};

}  // namespace twrench::robot

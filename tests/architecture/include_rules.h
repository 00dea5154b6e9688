#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace twrench {

/// A room is a folder below src that holds sources itself, by its path: "picture" and
/// "picture/space" are two rooms.
struct Room {
  std::set<std::string> rooms;      ///< other rooms whose headers its files may include
  std::set<std::string> libraries;  ///< libraries whose headers its files may include
};

/// The rules in docs/architecture.md.
struct IncludeRules {
  std::map<std::string, Room> rooms;
  std::map<std::string, std::string>
      libraries;  ///< by header ("zlib.h") or folder of headers ("Eigen/")
};

/// An #include line below src.
struct Include {
  std::string place;   ///< "math/so3.cpp:3"
  std::string room;    ///< the room of the file
  std::string header;  ///< as written in the line
  bool quoted;         ///< "...", else <...>
};

/// Reads the rules from the document's tables of rooms and of libraries.
IncludeRules read_include_rules(const std::string& document);

/// Return all #include lines and all rooms below `src`.
std::vector<Include> read_includes(const std::filesystem::path& src);
std::set<std::string> read_rooms(const std::filesystem::path& src);

/// Returns the violations of the rules, one sentence each: a room without a row or a row without a
/// room, an arrow to a room or a library that is not in the table, an arrow in the table that no
/// file needs, and a header that belongs to no room and no library. `rooms` are the existing rooms.
std::vector<std::string> broken_rules(const IncludeRules& rules, const std::set<std::string>& rooms,
                                      const std::vector<Include>& includes);

/// Returns the rooms that can be reached from themselves along the rules' arrows.
std::vector<std::string> rooms_in_circles(const IncludeRules& rules);

}  // namespace twrench

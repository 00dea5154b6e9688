#include "architecture/include_rules.h"

#include <optional>
#include <regex>
#include <sstream>
#include <string_view>

#include "architecture/markdown.h"

namespace twrench {
namespace {

namespace fs = std::filesystem;

std::set<std::string> set_of(const std::string& cell) {
  const std::vector<std::string> words = split_list(cell);
  return {words.begin(), words.end()};
}

/// Sources, and headers that CMake makes from a template (version.h.in).
bool is_source(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.ends_with(".h") || name.ends_with(".cpp") || name.ends_with(".h.in");
}

/// "picture/space/camera.h": "picture/space"
std::string folder_of(const std::string& path) { return fs::path(path).parent_path().string(); }

/// The prefix of the library's headers in #include lines: <twrench/motion/exact.h>.
constexpr std::string_view public_folder = "twrench/";

/// The library of a header: nothing for one of the C++ standard library, "" for a header of no
/// known library.
std::optional<std::string> library_of(const IncludeRules& rules, const std::string& header) {
  if (header.find_first_of("./") == std::string::npos) return std::nullopt;
  for (const auto& [pattern, library] : rules.libraries) {
    const bool is_folder = pattern.ends_with("/");
    if (is_folder ? header.starts_with(pattern) : header == pattern) return library;
  }
  return "";
}

/// cmake/Embed.cmake generates these headers for the room that embeds the files.
bool is_embedded(const Include& include) { return include.header.starts_with("embedded/"); }

struct Arrows {
  std::map<std::string, Room> used;
  std::vector<std::string> broken;
};

void follow(const IncludeRules& rules, const Include& include, Arrows& arrows) {
  const auto row = rules.rooms.find(include.room);
  if (row == rules.rooms.end() || is_embedded(include)) return;  // reported for the room
  const auto check = [&](const std::set<std::string>& allowed, std::set<std::string>& used,
                         const std::string& to) {
    used.insert(to);
    if (!allowed.contains(to)) {
      arrows.broken.push_back(include.place + ": " + include.room + " may not include " + to +
                              " (" + include.header + ")");
    }
  };
  if (include.quoted || include.header.starts_with(public_folder)) {
    const std::size_t prefix = include.quoted ? 0 : public_folder.size();
    const std::string to = folder_of(include.header.substr(prefix));
    if (to != include.room) check(row->second.rooms, arrows.used[include.room].rooms, to);
  } else if (const auto library = library_of(rules, include.header)) {
    if (library->empty()) {
      arrows.broken.push_back(include.place + ": <" + include.header + "> is of no known library");
    } else {
      check(row->second.libraries, arrows.used[include.room].libraries, *library);
    }
  }
}

}  // namespace

IncludeRules read_include_rules(const std::string& document) {
  IncludeRules rules;
  for (const auto& row : markdown_table(document, "room")) {
    rules.rooms[row.at(0)] = {set_of(row.at(2)), set_of(row.at(3))};
  }
  for (const auto& row : markdown_table(document, "library")) {
    for (const std::string& header : split_list(row.at(1))) rules.libraries[header] = row.at(0);
  }
  return rules;
}

std::vector<Include> read_includes(const fs::path& src) {
  static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  std::vector<Include> includes;
  for (const auto& entry : fs::recursive_directory_iterator(src)) {
    if (!entry.is_regular_file() || !is_source(entry.path())) continue;
    const std::string file = entry.path().lexically_relative(src).string();
    std::istringstream text(file_text(entry.path()));
    int number = 0;
    for (std::string line; std::getline(text, line);) {
      ++number;
      std::smatch match;
      if (line.find("include") == std::string::npos || !std::regex_search(line, match, pattern)) {
        continue;
      }
      includes.push_back({file + ":" + std::to_string(number), folder_of(file), match[2].str(),
                          match[1].str() == "\""});
    }
  }
  return includes;
}

std::set<std::string> read_rooms(const fs::path& src) {
  std::set<std::string> rooms;
  for (const auto& entry : fs::recursive_directory_iterator(src)) {
    if (entry.is_regular_file() && is_source(entry.path())) {
      rooms.insert(folder_of(entry.path().lexically_relative(src).string()));
    }
  }
  return rooms;
}

std::vector<std::string> broken_rules(const IncludeRules& rules, const std::set<std::string>& rooms,
                                      const std::vector<Include>& includes) {
  Arrows arrows;
  for (const std::string& room : rooms) {
    if (!rules.rooms.contains(room)) arrows.broken.push_back(room + " has no row in the table");
  }
  for (const Include& include : includes) follow(rules, include, arrows);
  for (const auto& [room, row] : rules.rooms) {
    if (!rooms.contains(room)) arrows.broken.push_back(room + " has a row, but no sources");
    const auto expect_used = [&, name = room](const std::set<std::string>& stated,
                                              const std::set<std::string>& used) {
      for (const std::string& to : stated) {
        if (used.contains(to)) continue;
        arrows.broken.push_back(name + " does not include " + to + ", as the table says it may");
      }
    };
    expect_used(row.rooms, arrows.used[room].rooms);
    expect_used(row.libraries, arrows.used[room].libraries);
  }
  return arrows.broken;
}

std::vector<std::string> rooms_in_circles(const IncludeRules& rules) {
  std::vector<std::string> found;
  for (const auto& [start, row] : rules.rooms) {
    std::set<std::string> reached;
    std::vector<std::string> to_visit(row.rooms.begin(), row.rooms.end());
    while (!to_visit.empty()) {
      const std::string room = to_visit.back();
      to_visit.pop_back();
      const auto next = rules.rooms.find(room);
      if (!reached.insert(room).second || next == rules.rooms.end()) continue;
      to_visit.insert(to_visit.end(), next->second.rooms.begin(), next->second.rooms.end());
    }
    if (reached.contains(start)) found.push_back(start);
  }
  return found;
}

}  // namespace twrench

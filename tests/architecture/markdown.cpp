#include "architecture/markdown.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace twrench {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> pieces;
  std::istringstream stream(text);
  for (std::string piece; std::getline(stream, piece, separator);) {
    pieces.push_back(trimmed(piece));
  }
  return pieces;
}

/// The cells of "| a | b |"; none if the line is not a row of a table.
std::vector<std::string> cells_of(std::string line) {
  if (!line.starts_with("|")) return {};
  std::erase(line, '`');
  return split(line.substr(1, line.find_last_of('|') - 1) + " ", '|');
}

}  // namespace

std::filesystem::path project_folder() {
  return std::filesystem::path(TWRENCH_TESTS_DIR).parent_path();
}

std::string file_text(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

MarkdownRows markdown_table(const std::string& text, const std::string& heading) {
  MarkdownRows rows;
  bool inside = false;
  for (const std::string& line : split(text, '\n')) {
    const std::vector<std::string> cells = cells_of(line);
    if (inside && cells.empty()) break;
    if (inside) rows.push_back(cells);
    inside = inside || (!cells.empty() && cells[0] == heading);
  }
  if (rows.empty()) throw std::runtime_error("no table begins with the column '" + heading + "'");
  rows.erase(rows.begin());  // the rule below the heading
  return rows;
}

std::vector<std::string> split_list(const std::string& cell) {
  std::vector<std::string> words = split(cell, ',');
  std::erase(words, "");
  return words;
}

std::vector<std::string> code_spans(const std::string& text) {
  std::vector<std::string> spans;
  for (const std::string& line : split(text, '\n')) {
    const std::vector<std::string> pieces = split(line, '`');
    for (std::size_t i = 1; i < pieces.size(); i += 2) spans.push_back(pieces[i]);
  }
  return spans;
}

}  // namespace twrench

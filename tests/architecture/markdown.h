#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace twrench {

/// The root folder of the project.
std::filesystem::path project_folder();

/// The text of a file. Throws std::runtime_error if it cannot be read.
std::string file_text(const std::filesystem::path& path);

/// The rows of a Markdown table without its heading and its rule; each row is its cells, trimmed
/// and without backticks.
using MarkdownRows = std::vector<std::vector<std::string>>;

/// The first table of `text` whose heading's first cell is `heading`. Throws std::runtime_error if
/// there is none.
MarkdownRows markdown_table(const std::string& text, const std::string& heading);

/// "a, b": the words between the commas, trimmed; none in an empty cell.
std::vector<std::string> split_list(const std::string& cell);

/// The pieces of a text between backticks on one line.
std::vector<std::string> code_spans(const std::string& text);

}  // namespace twrench

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/parallel.h"
#include "mesh/formats.h"
#include "mesh/line_reader.h"

namespace twrench::mesh {
namespace {

constexpr std::size_t header_bytes = 84, triangle_bytes = 50;

/// Returns the number of triangles in the header of a binary file.
std::uint64_t triangle_count(std::string_view bytes) { return number_at<std::uint32_t>(bytes, 80); }

std::uint64_t expected_bytes(std::string_view bytes) {
  return header_bytes + triangle_bytes * triangle_count(bytes);
}

/// Reads the vertices of the record at `begin`, which consists of a normal of 12 bytes, three
/// vertices of 12 bytes each, and 2 bytes of attributes.
void read_record(std::string_view bytes, std::size_t begin, std::size_t triangle,
                 body::TriangleMesh& mesh) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t at = begin + 12 * (k + 1);
    mesh.vertices[3 * triangle + k] = {number_at<float>(bytes, at), number_at<float>(bytes, at + 4),
                                       number_at<float>(bytes, at + 8)};
    mesh.triangles[triangle][k] = static_cast<std::uint32_t>(3 * triangle + k);
  }
}

/// Returns where the record of a triangle begins if all have the same length.
std::size_t plain_record(std::size_t triangle) { return header_bytes + triangle_bytes * triangle; }

/// Returns where the records of a file begin in which the attributes of each state how many bytes
/// follow it, and where the last one ends. Nothing if the file is too short for that, so that the
/// attributes have another meaning, such as colours. The file must have room for all triangles.
std::optional<std::vector<std::size_t>> records_with_payload(std::string_view bytes) {
  std::vector<std::size_t> begins{header_bytes};
  for (std::uint64_t i = 0; i < triangle_count(bytes); ++i) {
    const std::size_t end = begins.back() + triangle_bytes;
    if (end > bytes.size()) return {};
    begins.push_back(end + number_at<std::uint16_t>(bytes, end - 2));
  }
  if (begins.back() > bytes.size()) return {};
  return begins;
}

/// Reads a binary file. `begin_of` returns where the record of a triangle begins.
Content read_binary(const Source& source, auto begin_of) {
  const std::string_view bytes = source.bytes;
  const std::uint64_t count = triangle_count(bytes);
  Content content;
  body::TriangleMesh& mesh = content.mesh;
  mesh.vertices.resize(3 * count);
  mesh.triangles.resize(count);
  for_each_part(count, 1 << 16, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      read_record(bytes, begin_of(i), i, mesh);
      for (std::size_t k = 0; k < 3; ++k) {
        if (mesh.vertices[3 * i + k].allFinite()) continue;
        throw InvalidArgument(fmt::format("{}: triangle {}", source.name, i + 1),
                              "a coordinate is not a finite number");
      }
    }
  });
  return content;
}

/// Reads a binary file that is longer than its triangles need.
Content read_longer_binary(const Source& source) {
  const std::size_t more = source.bytes.size() - expected_bytes(source.bytes);
  const auto with_payload = records_with_payload(source.bytes);
  if (with_payload && with_payload->back() == source.bytes.size()) {
    Content content = read_binary(source, [&](std::size_t i) { return (*with_payload)[i]; });
    content.notes.push_back(
        fmt::format("the attributes of its triangles, {} bytes, are left out", more));
    return content;
  }
  if (with_payload && with_payload->back() > expected_bytes(source.bytes)) {
    throw system::FileError(
        "cannot read " + source.name,
        fmt::format("it has {} bytes more than its {} triangles need, and those may be attributes "
                    "of the triangles or follow the last one",
                    more, triangle_count(source.bytes)),
        "save it without attributes");
  }
  Content content = read_binary(source, plain_record);
  content.notes.push_back(fmt::format("the {} bytes after its last triangle are left out", more));
  return content;
}

/// Returns the next word of the line in lower case, because some programs write keywords in
/// capitals.
std::string keyword(LineReader& lines) {
  std::string word(lines.word());
  std::ranges::transform(word, word.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word;
}

class TextReader {
 public:
  explicit TextReader(const Source& source)
      : name_(source.name), lines_(source.name, source.bytes) {}

  Content read() {
    std::vector<std::string> notes;
    while (next_line()) {
      if (is("solid")) {
        read_solid();
        continue;
      }
      // The first line is "solid", so this one follows an "endsolid".
      if (is("facet") || has_facets_after(lines_)) throw expected("solid");
      notes.push_back(fmt::format("the text from line {} on, after 'endsolid', is left out",
                                  lines_.line_number()));
      break;
    }
    return {.mesh = std::move(mesh_), .notes = std::move(notes)};
  }

 private:
  static bool has_facets_after(LineReader lines) {
    while (lines.next()) {
      if (keyword(lines) == "facet") return true;
    }
    return false;
  }

  void read_solid() {
    while (next_line()) {
      if (is("endsolid")) return;
      if (!is("facet")) throw expected("facet");
      read_facet();
    }
    throw cut_off();
  }

  void read_facet() {
    expect("outer");
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    for (int k = 0; k < 3; ++k) {
      expect("vertex");
      const double x = lines_.number(), y = lines_.number(), z = lines_.number();
      mesh_.vertices.emplace_back(x, y, z);
    }
    expect("endloop");
    expect("endfacet");
    mesh_.triangles.push_back({first, first + 1, first + 2});
  }

  /// Advances to the next line that is not empty and reads its first word.
  bool next_line() {
    while (lines_.next()) {
      keyword_ = keyword(lines_);
      if (!keyword_.empty()) return true;
    }
    return false;
  }

  bool is(std::string_view word) const { return keyword_ == word; }

  void expect(const char* word) {
    if (!next_line()) throw cut_off();
    if (!is(word)) throw expected(word);
  }

  system::FileError expected(const char* word) const {
    return lines_.bad(fmt::format("'{}' should stand here, not {}", word, shown(keyword_)));
  }

  system::FileError cut_off() const {
    return {"cannot read " + name_,
            fmt::format("it is cut off: it ends after {} triangles without 'endsolid'",
                        mesh_.triangles.size())};
  }

  std::string name_;
  LineReader lines_;
  std::string keyword_;
  body::TriangleMesh mesh_;
};

/// Returns whether the file begins with "solid" and has no NUL where the triangle count of a binary
/// file contains one.
bool is_text(std::string_view bytes) {
  LineReader lines("", bytes);
  std::string first;
  while (first.empty() && lines.next()) first = keyword(lines);
  return first == "solid" && bytes.substr(0, header_bytes).find('\0') == std::string_view::npos;
}

/// Returns whether what would be the header and the triangle count of a binary file is ASCII text.
bool begins_with_ascii(std::string_view bytes) {
  return std::ranges::all_of(bytes.substr(0, header_bytes), [](unsigned char c) {
    return c < 0x80 && (std::isprint(c) || std::isspace(c));
  });
}

/// Returns whether a line at the beginning of a text file begins with "facet" or "endsolid".
bool has_lines(std::string_view bytes) {
  LineReader lines("", bytes.substr(0, 4096));
  while (lines.next()) {
    const std::string word = keyword(lines);
    if (word == "facet" || word == "endsolid") return true;
  }
  return false;
}

}  // namespace

bool is_binary_stl(std::string_view bytes) {
  return bytes.size() >= header_bytes && bytes.size() == expected_bytes(bytes);
}

Content read_stl(const Source& source) {
  const std::string_view bytes = source.bytes;
  const std::string what = "cannot read " + source.name;
  if (is_binary_stl(bytes)) return read_binary(source, plain_record);
  if (is_text(bytes) && has_lines(bytes)) return TextReader(source).read();
  if (bytes.size() < header_bytes) {
    throw system::FileError(what, fmt::format("{} bytes are no STL file, whose header alone has {}",
                                              bytes.size(), header_bytes));
  }
  if (is_text(bytes)) {
    throw system::FileError(what, "it begins as a text STL, but no line begins with 'facet'",
                            "put each 'facet', 'vertex' and 'endfacet' on a separate line");
  }
  if (begins_with_ascii(bytes)) {
    throw system::FileError(what, "it is text, but does not begin with 'solid'",
                            "save it as STL, or give it the extension of its format");
  }
  if (bytes.size() > expected_bytes(bytes) && triangle_count(bytes) > 0) {
    return read_longer_binary(source);
  }
  if (bytes.size() < expected_bytes(bytes)) {
    const std::uint64_t whole = (bytes.size() - header_bytes) / triangle_bytes;
    throw system::FileError(
        what, fmt::format("it is cut off: {} of {} triangles are missing, because it has {} bytes "
                          "of {}",
                          triangle_count(bytes) - whole, triangle_count(bytes), bytes.size(),
                          expected_bytes(bytes)));
  }
  throw system::FileError(what,
                          fmt::format("it is no STL file, or damaged: {} triangles take {} bytes, "
                                      "but it has {}",
                                      triangle_count(bytes), expected_bytes(bytes), bytes.size()));
}

}  // namespace twrench::mesh

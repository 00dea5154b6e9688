#include "mesh/stl.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/parallel.h"
#include "mesh/binary.h"
#include "mesh/line_reader.h"

namespace twrench::mesh {
namespace {

constexpr std::size_t header_bytes = 84, triangle_bytes = 50;

/// Returns the number of triangles in the header of a binary file.
std::uint64_t triangle_count(std::string_view bytes) { return number_at<std::uint32_t>(bytes, 80); }

std::uint64_t expected_bytes(std::string_view bytes) {
  return header_bytes + triangle_bytes * triangle_count(bytes);
}

/// Reads the vertices of a record, which consists of a normal of 12 bytes, three vertices of 12
/// bytes each, and 2 bytes of attributes.
void read_record(std::string_view bytes, std::size_t triangle, body::TriangleMesh& mesh) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t at = header_bytes + triangle_bytes * triangle + 12 * (k + 1);
    mesh.vertices[3 * triangle + k] = {number_at<float>(bytes, at), number_at<float>(bytes, at + 4),
                                       number_at<float>(bytes, at + 8)};
    mesh.triangles[triangle][k] = static_cast<std::uint32_t>(3 * triangle + k);
  }
}

Content read_binary(const Source& source) {
  const std::string_view bytes = source.bytes;
  const std::uint64_t count = triangle_count(bytes);
  Content content;
  body::TriangleMesh& mesh = content.mesh;
  mesh.vertices.resize(3 * count);
  mesh.triangles.resize(count);
  for_each_part(count, 1 << 16, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      read_record(bytes, i, mesh);
      for (std::size_t k = 0; k < 3; ++k) {
        if (mesh.vertices[3 * i + k].allFinite()) continue;
        throw InvalidArgument(fmt::format("{}: triangle {}", source.name, i + 1),
                              "a coordinate is not a finite number");
      }
    }
  });
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
    while (next_line()) {
      if (is("solid"))
        read_solid();
      else
        throw expected("solid");
    }
    return {.mesh = std::move(mesh_)};
  }

 private:
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

/// Returns whether the file begins as a text file: "solid" and a name, then a line with "facet" or
/// "endsolid".
bool begins_as_text(std::string_view bytes) {
  LineReader lines("", bytes.substr(0, 4096));
  if (!lines.next() || keyword(lines) != "solid") return false;
  while (lines.next()) {
    const std::string word = keyword(lines);
    if (word == "facet" || word == "endsolid") return true;
  }
  return false;
}

/// Returns whether the file begins with "solid" and has no NUL in its first bytes, unlike a binary
/// file, whose triangle count contains one.
bool is_text(std::string_view bytes) {
  LineReader lines("", bytes);
  return lines.next() && keyword(lines) == "solid" &&
         bytes.substr(0, 4096).find('\0') == std::string_view::npos;
}

}  // namespace

bool is_binary_stl(std::string_view bytes) {
  return bytes.size() >= header_bytes && bytes.size() == expected_bytes(bytes);
}

Content read_stl(const Source& source) {
  const std::string_view bytes = source.bytes;
  if (is_binary_stl(bytes)) return read_binary(source);
  if (begins_as_text(bytes)) return TextReader(source).read();
  const std::string what = "cannot read " + source.name;
  if (bytes.size() < header_bytes) {
    throw system::FileError(what, fmt::format("{} bytes are no STL file", bytes.size()));
  }
  if (is_text(bytes)) {
    throw system::FileError(what, "it begins as a text STL, but no line begins with 'facet'",
                            "put each 'facet', 'vertex' and 'endfacet' on a separate line");
  }
  throw system::FileError(
      what,
      fmt::format("it is {}: {} triangles take {} bytes, but it has {}",
                  bytes.size() < expected_bytes(bytes) ? "cut off" : "no STL file, or damaged",
                  triangle_count(bytes), expected_bytes(bytes), bytes.size()));
}

}  // namespace twrench::mesh

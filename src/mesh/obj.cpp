#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/formats.h"
#include "mesh/line_reader.h"
#include "mesh/polygon.h"

namespace twrench::mesh {
namespace {

class ObjReader {
 public:
  explicit ObjReader(const Source& source) : lines_(source.name, source.bytes) {}

  Content read() {
    while (lines_.next_statement()) {
      const std::string_view keyword = lines_.word();
      if (keyword == "v") read_vertex();
      if (keyword == "f") read_face();
    }
    require_indices_in_range();
    polygons_.triangulate(mesh_);
    if (!mesh_.colors.empty()) mesh_.colors.resize(mesh_.vertices.size(), white);
    return {.mesh = std::move(mesh_)};
  }

 private:
  static constexpr std::array<float, 3> white{1.0F, 1.0F, 1.0F};

  void read_vertex() {
    const double x = lines_.number(), y = lines_.number(), z = lines_.number();
    mesh_.vertices.emplace_back(x, y, z);
    // Three more numbers are a colour. A single one is a weight, which only affects curves.
    LineReader rest = lines_;
    if (rest.word().empty() || rest.word().empty()) return;
    mesh_.colors.resize(mesh_.vertices.size(), white);
    for (float& component : mesh_.colors.back()) {
      component = static_cast<float>(std::clamp(lines_.number(), 0.0, 1.0));
    }
  }

  void read_face() {
    ring_.clear();
    for (std::string_view word = lines_.word(); !word.empty(); word = lines_.word()) {
      ring_.push_back(index_of(word));
    }
    if (ring_.size() < 3) {
      throw InvalidArgument(lines_.place(),
                            "a face has three corners at least" + lines_.note_on_end());
    }
    polygons_.add(ring_, mesh_);
  }

  /// Returns the index, from 0, of a corner such as "7", "7/1", "7//3" or "-1". Negative numbers
  /// count back from the vertex read last.
  std::uint32_t index_of(std::string_view word) {
    const std::string_view text = word.substr(0, word.find('/'));
    std::int64_t number = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || stop != text.data() + text.size()) {
      throw lines_.bad(fmt::format("{} is no index of a vertex", shown(word)));
    }
    const auto count = static_cast<std::int64_t>(mesh_.vertices.size());
    const std::int64_t index = number > 0 ? number - 1 : count + number;
    constexpr std::int64_t most = 0xFFFFFFFE;
    if (number == 0 || index < 0 || index > most) throw out_of_range(lines_.place(), word);
    // The vertex may follow later in the file.
    if (index >= count && (!farthest_ || index > farthest_->index)) {
      farthest_ = Reference{index, lines_.line_number(), std::string(word)};
    }
    return static_cast<std::uint32_t>(index);
  }

  InvalidArgument out_of_range(const std::string& place, std::string_view word) const {
    return {place, fmt::format("the face refers to vertex {}, but there are {} vertices",
                               word.substr(0, word.find('/')), mesh_.vertices.size())};
  }

  void require_indices_in_range() const {
    if (!farthest_) return;
    if (farthest_->index < static_cast<std::int64_t>(mesh_.vertices.size())) return;
    throw out_of_range(lines_.place(farthest_->line_number), farthest_->word);
  }

  /// A corner that was read before its vertex.
  struct Reference {
    std::int64_t index;
    std::size_t line_number;
    std::string word;
  };

  LineReader lines_;
  body::TriangleMesh mesh_;
  std::vector<std::uint32_t> ring_;
  Polygons polygons_;
  std::optional<Reference> farthest_;
};

}  // namespace

Content read_obj(const Source& source) { return ObjReader(source).read(); }

}  // namespace twrench::mesh

#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

namespace twrench::interchange {

/// A glTF 2.0 document under construction, with one buffer. References within a document are
/// indices into its arrays.
class Gltf {
 public:
  using Json = nlohmann::ordered_json;

  /// The use of an array of numbers.
  enum class Use { vertices, keys };

  /// Creates an empty document, written by the program `generator`.
  explicit Gltf(const std::string& generator);

  /// Appends an object to the document's array of that name; returns its index.
  std::size_t add(const std::string& array, Json object);

  /// Adds float32 numbers to the buffer and an accessor to them, with `components` (1, 3 or 4) per
  /// element; returns its index.
  std::size_t add_floats(std::span<const float> numbers, std::size_t components, Use use);

  /// Adds an accessor to the indices of triangles; returns its index.
  std::size_t add_indices(std::span<const std::uint32_t> indices);

  /// Writes the document as a binary file (.glb) in pieces. Equal documents give equal bytes.
  void write_glb(const std::function<void(std::string_view)>& write) const;

 private:
  std::size_t add_view(std::size_t begin, int target);

  Json root_;
  std::string buffer_;
};

}  // namespace twrench::interchange

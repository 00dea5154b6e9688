#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "mesh/gltf_buffers.h"
#include "mesh/gltf_json.h"

namespace twrench::mesh {

/// Elements of one or more numbers each in a buffer view.
class GltfElements {
 public:
  /// `place` is the object that names the buffer view, and `type` its type of numbers. Throws
  /// system::FileError if the buffer view has too few bytes.
  GltfElements(const GltfValue& place, const GltfValue& type, std::uint64_t count,
               std::size_t components, GltfBuffers& buffers);

  std::size_t size() const { return count_; }
  /// Returns whether the numbers are unsigned integers, as indices must be.
  bool is_unsigned() const;
  /// Returns a number. A normalized integer is divided by the greatest one of its type.
  double at(std::size_t element, std::size_t component, bool is_normalized) const;

 private:
  std::uint64_t type_;
  std::size_t count_, stride_;
  std::string_view bytes_;
};

/// The numbers of an accessor, one for each component of each element. A sparse accessor replaces
/// some elements of a buffer view, or some of elements that are otherwise 0.
class GltfAccessor {
 public:
  /// Throws system::FileError if the accessor is damaged. Takes the same time for any count.
  GltfAccessor(const GltfValue& accessor, GltfBuffers& buffers);

  /// Throws system::FileError unless the indices of a sparse accessor are in order and in range, as
  /// at() requires.
  void require_order() const;

  std::size_t size() const { return count_; }
  std::size_t components() const { return components_; }
  /// Returns whether the numbers are unsigned integers, as indices must be.
  bool is_unsigned() const;
  double at(std::size_t element, std::size_t component) const;

 private:
  /// Returns the number of replaced elements before `element`.
  std::size_t replaced_before(std::size_t element) const;

  /// The replaced elements of a sparse accessor.
  struct Sparse {
    GltfValue place;
    GltfElements indices, values;
  };

  std::size_t count_, components_;
  bool is_normalized_ = false;
  std::optional<GltfElements> elements_;
  std::optional<Sparse> sparse_;
};

}  // namespace twrench::mesh

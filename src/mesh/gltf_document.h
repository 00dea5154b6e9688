#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/formats.h"
#include "system/error.h"

namespace twrench::mesh {

/// A value in the JSON of a glTF file. It knows its place, which messages quote.
class GltfValue {
 public:
  /// The whole document; it must outlive the value.
  GltfValue(const std::string& file, const nlohmann::json& json) : file_(&file), json_(&json) {}

  /// Returns the place of the value: "nodes[3].mesh".
  const std::string& place() const { return place_; }

  /// Returns the error about this value: "cannot read FILE: PLACE WHY".
  system::FileError bad(const std::string& why) const;

  /// Returns the value under a key of an object; nothing if there is none.
  std::optional<GltfValue> find(const char* key) const;
  GltfValue at(const char* key) const;

  /// Returns the number of entries of an array; throws if the value is not an array.
  std::size_t size() const;
  GltfValue at(std::uint64_t index) const;
  /// Returns the number of entries of the array under a key; 0 if there is none.
  std::size_t size(const char* key) const;

  // The value as the required type; each throws if it is of another type.
  std::uint64_t whole() const;
  double number() const;
  bool boolean() const;
  const std::string& text() const;
  std::vector<double> numbers(std::size_t count) const;

  std::uint64_t whole_or(const char* key, std::uint64_t otherwise) const;

 private:
  GltfValue(const GltfValue& parent, const nlohmann::json& json, std::string place)
      : file_(parent.file_), json_(&json), place_(std::move(place)) {}

  const std::string* file_;
  const nlohmann::json* json_;
  std::string place_;
};

/// The chunks of a glTF file.
struct GltfChunks {
  std::string_view json;
  /// The first buffer of a .glb file, if it has one.
  std::optional<std::string_view> binary;
};

/// Returns the chunks of a .glb file; a .gltf file is a single JSON chunk. Throws system::FileError
/// if a chunk is cut off.
GltfChunks gltf_chunks(const Source& source);

/// A part of a buffer.
struct GltfView {
  std::string_view bytes;
  /// The bytes from one element to the next, if specified.
  std::optional<std::size_t> stride;
};

/// The buffers of a glTF file, read on demand.
class GltfBuffers {
 public:
  /// `binary` is the binary chunk of a .glb file. All must outlive the buffers.
  GltfBuffers(const Source& source, const GltfValue& document,
              std::optional<std::string_view> binary)
      : source_(&source), document_(&document), binary_(binary) {}

  /// Returns a buffer view. Throws system::FileError if its buffer has too few bytes, and
  /// InvalidArgument if the buffer is in a file that may not be read.
  GltfView view(std::uint64_t index);

  /// Returns the number of bytes read from other files.
  std::size_t bytes() const;

  /// Returns the files that were read, in the order of the buffers.
  std::vector<OtherFile> files() const;

 private:
  /// A file that was read. Several buffers may refer to it.
  struct File {
    std::string bytes;
    OtherFile file;
  };
  struct Buffer {
    std::string owned;
    std::string_view bytes;
    const File* file = nullptr;  ///< Null if the bytes are in the document itself.
  };

  const Buffer& buffer(std::uint64_t index);
  void load(const GltfValue& value, std::uint64_t index, Buffer& buffer);
  const File& load_file(const GltfValue& uri);

  const Source* source_;
  const GltfValue* document_;
  std::optional<std::string_view> binary_;
  std::vector<std::optional<Buffer>> buffers_;
  std::deque<File> files_;  ///< Its elements do not move.
};

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

#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/gltf_json.h"
#include "mesh/source.h"

namespace twrench::mesh {

/// A part of a buffer.
struct GltfView {
  std::string_view bytes;
  /// The bytes from one element to the next, where it says so.
  std::optional<std::size_t> stride;
};

/// The buffers of a glTF file, which are read when they are needed.
class GltfBuffers {
 public:
  /// `binary` is the binary chunk of a .glb file. All must outlive the buffers.
  GltfBuffers(const Source& source, const GltfValue& document,
              std::optional<std::string_view> binary)
      : source_(&source), document_(&document), binary_(binary) {}

  /// Returns a buffer view. Throws system::FileError where there are not as many as
  /// the view says, and InvalidArgument where they are in a place that is not read.
  GltfView view(std::uint64_t index);

  /// Returns how many bytes were read from other files.
  std::size_t bytes() const;

  /// The files that were read, in the order of the buffers.
  std::vector<OtherFile> files() const;

 private:
  /// A file that was read, however many buffers refer to it.
  struct File {
    std::string bytes;
    OtherFile file;
  };
  struct Buffer {
    std::string owned;
    std::string_view bytes;
    const File* file = nullptr;  ///< Null where the bytes are in the document itself.
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

/// The numbers of an accessor, one for each component of each element.
class GltfAccessor {
 public:
  /// Throws system::FileError where the accessor is damaged.
  GltfAccessor(const GltfValue& accessor, GltfBuffers& buffers);

  std::size_t size() const { return count_; }
  std::size_t components() const { return components_; }
  /// Whether the numbers are whole ones without a sign, as indices are.
  bool is_unsigned() const;
  double at(std::size_t element, std::size_t component) const;

 private:
  std::uint64_t type_;
  std::size_t count_, components_, stride_;
  bool normalized_ = false;
  std::string_view bytes_;
};

}  // namespace twrench::mesh

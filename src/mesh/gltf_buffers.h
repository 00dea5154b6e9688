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

}  // namespace twrench::mesh

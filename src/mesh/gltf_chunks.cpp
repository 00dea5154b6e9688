#include "mesh/gltf_chunks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "mesh/binary.h"
#include "system/error.h"

namespace twrench::mesh {

GltfChunks gltf_chunks(const Source& source) {
  if (!source.bytes.starts_with("glTF")) return {source.bytes, {}};
  constexpr std::size_t header = 12, chunk_header = 8;
  constexpr std::uint32_t json_type = 0x4E4F534A, binary_type = 0x004E4942;
  const std::string what = "cannot read " + source.name;
  std::string_view rest = source.bytes;
  if (rest.size() < header) throw system::FileError(what, "it is cut off in its header");
  const auto length = number_at<std::uint32_t>(rest, 8);
  if (length > rest.size()) {
    throw system::FileError(
        what, fmt::format("it is cut off: it has {} bytes of {}", rest.size(), length));
  }
  GltfChunks chunks;
  rest = rest.substr(header, std::max<std::size_t>(length, header) - header);
  while (rest.size() >= chunk_header) {
    const auto size = number_at<std::uint32_t>(rest, 0), type = number_at<std::uint32_t>(rest, 4);
    rest.remove_prefix(chunk_header);
    if (size > rest.size())
      throw system::FileError(what, "it is damaged: a chunk goes beyond its end");
    if (type == json_type && chunks.json.empty()) chunks.json = rest.substr(0, size);
    if (type == binary_type && !chunks.binary) chunks.binary = rest.substr(0, size);
    rest.remove_prefix(size);
  }
  return chunks;
}

}  // namespace twrench::mesh

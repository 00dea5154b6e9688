#include "mesh/gltf_buffers.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <set>
#include <span>

#include "system/base64.h"
#include "system/file.h"
#include "system/sha256.h"

namespace twrench::mesh {
namespace {

constexpr std::size_t most_buffer_bytes = std::size_t{1} << 30U;

/// Decodes escapes such as %20 in a URI.
std::string unescaped(std::string_view uri) {
  std::string text;
  while (!uri.empty()) {
    unsigned char byte = 0;
    const char* const digits = uri.data() + 1;
    if (uri.size() > 2 && uri[0] == '%' &&
        std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
      text += static_cast<char>(byte);
      uri.remove_prefix(3);
    } else {
      text += uri[0];
      uri.remove_prefix(1);
    }
  }
  return text;
}

bool is_plain_name(const std::string& name) {
  return !name.empty() && name != "." && name != ".." &&
         name.find_first_of(std::string_view("/\\:\0", 4)) == std::string::npos;
}

std::string_view text_of(const std::vector<std::uint8_t>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

const GltfBuffers::File& GltfBuffers::load_file(const GltfValue& uri) {
  std::string name = unescaped(uri.text());
  while (name.starts_with("./")) name.erase(0, 2);
  if (!source_->folder || !is_plain_name(name)) {
    throw InvalidArgument(source_->name,
                          fmt::format("its {} refers to '{}', which is not beside it", uri.place(),
                                      name.substr(0, 80)),
                          "put all into one file: save it as .glb");
  }
  const std::filesystem::path path = *source_->folder / name;
  const auto known =
      std::ranges::find(files_, path, [](const File& file) { return file.file.path; });
  if (known != files_.end()) return *known;
  const auto bytes = system::read_regular_file(path, most_buffer_bytes);
  return files_.emplace_back(File{std::string(text_of(bytes)), {path, system::sha256_hex(bytes)}});
}

void GltfBuffers::load(const GltfValue& value, std::uint64_t index, Buffer& buffer) {
  const std::optional<GltfValue> uri = value.find("uri");
  if (!uri && index == 0 && binary_) {
    buffer.bytes = *binary_;
    return;
  }
  if (!uri) throw value.bad("has no 'uri'");
  const std::string_view text = uri->text();
  if (text.starts_with("data:")) {
    constexpr std::string_view mark = ";base64,";
    const std::size_t at = text.find(mark);
    const auto bytes = at == std::string_view::npos
                           ? std::nullopt
                           : system::bytes_of_base64(text.substr(at + mark.size()));
    if (!bytes) throw uri->bad("is no data in base64");
    buffer.owned = text_of(*bytes);
    buffer.bytes = buffer.owned;
  } else {
    buffer.file = &load_file(*uri);
    buffer.bytes = buffer.file->bytes;
  }
}

const GltfBuffers::Buffer& GltfBuffers::buffer(std::uint64_t index) {
  const GltfValue value = document_->at("buffers").at(index);
  // Sized once: `bytes` of a short buffer points into its string and would not survive a move.
  if (buffers_.empty()) buffers_.resize(document_->size("buffers"));
  std::optional<Buffer>& slot = buffers_[index];
  if (slot) return *slot;
  load(value, index, slot.emplace());
  const std::uint64_t length = value.at("byteLength").whole();
  if (length > slot->bytes.size()) {
    throw value.bad(fmt::format("is cut off: it has {} bytes of {}", slot->bytes.size(), length));
  }
  slot->bytes = slot->bytes.substr(0, length);
  return *slot;
}

GltfView GltfBuffers::view(std::uint64_t index) {
  const GltfValue value = document_->at("bufferViews").at(index);
  const std::string_view bytes = buffer(value.at("buffer").whole()).bytes;
  const std::uint64_t offset = value.whole_or("byteOffset", 0);
  const std::uint64_t length = value.at("byteLength").whole();
  if (offset > bytes.size() || length > bytes.size() - offset) {
    throw value.bad(fmt::format("goes beyond the {} bytes of its buffer", bytes.size()));
  }
  GltfView view{bytes.substr(offset, length), {}};
  if (const auto stride = value.find("byteStride")) {
    view.stride = stride->whole();
    if (*view.stride == 0 || *view.stride > 252) throw stride->bad("is no distance of elements");
  }
  return view;
}

std::vector<OtherFile> GltfBuffers::files() const {
  std::vector<OtherFile> files;
  std::set<const File*> listed;
  for (const std::optional<Buffer>& buffer : buffers_) {
    const bool is_new = buffer && buffer->file != nullptr && listed.insert(buffer->file).second;
    if (is_new) files.push_back(buffer->file->file);
  }
  return files;
}

std::size_t GltfBuffers::bytes() const {
  std::size_t sum = 0;
  for (const File& file : files_) sum += file.bytes.size();
  return sum;
}

}  // namespace twrench::mesh

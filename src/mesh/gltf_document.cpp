#include "mesh/gltf_document.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "mesh/formats.h"
#include "system/bytes.h"
#include "system/file.h"

namespace twrench::mesh {

system::FileError GltfValue::bad(const std::string& why) const {
  return {"cannot read " + *file_, fmt::format("its {} {}", place_.empty() ? "JSON" : place_, why)};
}

std::optional<GltfValue> GltfValue::find(const char* key) const {
  if (!json_->is_object()) throw bad("is no object");
  const auto found = json_->find(key);
  if (found == json_->end()) return {};
  return GltfValue(*this, *found, place_.empty() ? key : place_ + "." + key);
}

GltfValue GltfValue::at(const char* key) const {
  if (auto found = find(key)) return *std::move(found);
  throw bad(fmt::format("has no '{}'", key));
}

std::size_t GltfValue::size() const {
  if (!json_->is_array()) throw bad("is no array");
  return json_->size();
}

GltfValue GltfValue::at(std::uint64_t index) const {
  if (index >= size())
    throw bad(fmt::format("has {} entries, but {} is referred to", size(), index));
  return {*this, (*json_)[index], fmt::format("{}[{}]", place_, index)};
}

std::size_t GltfValue::size(const char* key) const {
  const std::optional<GltfValue> list = find(key);
  return list ? list->size() : 0;
}

std::uint64_t GltfValue::whole() const {
  if (!json_->is_number_unsigned()) throw bad("is no whole number");
  return json_->get<std::uint64_t>();
}

double GltfValue::number() const {
  if (!json_->is_number()) throw bad("is no number");
  return json_->get<double>();
}

bool GltfValue::boolean() const {
  if (!json_->is_boolean()) throw bad("is neither true nor false");
  return json_->get<bool>();
}

const std::string& GltfValue::text() const {
  if (!json_->is_string()) throw bad("is no text");
  return json_->get_ref<const std::string&>();
}

std::vector<double> GltfValue::numbers(std::size_t count) const {
  if (size() != count) throw bad(fmt::format("must have {} numbers", count));
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(at(i).number());
  return values;
}

std::uint64_t GltfValue::whole_or(const char* key, std::uint64_t otherwise) const {
  const std::optional<GltfValue> value = find(key);
  return value ? value->whole() : otherwise;
}

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

namespace {

// glTF's numbers of component types, which are OpenGL's.
constexpr std::uint64_t int8 = 5120, uint8 = 5121, int16 = 5122, uint16 = 5123, uint32 = 5125,
                        float32 = 5126;

std::size_t size_of_component(const GltfValue& type) {
  switch (type.whole()) {
    case int8:
    case uint8:
      return 1;
    case int16:
    case uint16:
      return 2;
    case uint32:
    case float32:
      return 4;
    default:
      throw type.bad("is no type of numbers");
  }
}

std::size_t components_of(const GltfValue& type) {
  static const std::map<std::string, std::size_t> components{
      {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}};
  const auto found = components.find(type.text());
  if (found == components.end()) throw type.bad("is no type of elements");
  return found->second;
}

template <typename Number>
double component(std::string_view bytes, std::size_t offset, bool normalized) {
  const auto value = static_cast<double>(number_at<Number>(bytes, offset));
  if (!normalized) return value;
  return std::max(value / static_cast<double>(std::numeric_limits<Number>::max()), -1.0);
}

}  // namespace

GltfElements::GltfElements(const GltfValue& place, const GltfValue& type, std::uint64_t count,
                           std::size_t components, GltfBuffers& buffers)
    : type_(type.whole()), count_(count) {
  const std::size_t size = components * size_of_component(type);
  const GltfView view = buffers.view(place.at("bufferView").whole());
  bytes_ = view.bytes;
  stride_ = view.stride.value_or(size);
  const std::uint64_t offset = place.whole_or("byteOffset", 0);
  const bool has_room = offset <= bytes_.size() &&
                        (count_ == 0 || (bytes_.size() - offset >= size &&
                                         count_ - 1 <= (bytes_.size() - offset - size) / stride_));
  if (!has_room) {
    throw place.bad(fmt::format("goes beyond the {} bytes of its buffer view", bytes_.size()));
  }
  bytes_.remove_prefix(offset);
}

bool GltfElements::is_unsigned() const {
  return type_ == uint8 || type_ == uint16 || type_ == uint32;
}

double GltfElements::at(std::size_t element, std::size_t index, bool is_normalized) const {
  const std::size_t begin = element * stride_;
  switch (type_) {
    case int8:
      return component<std::int8_t>(bytes_, begin + index, is_normalized);
    case uint8:
      return component<std::uint8_t>(bytes_, begin + index, is_normalized);
    case int16:
      return component<std::int16_t>(bytes_, begin + 2 * index, is_normalized);
    case uint16:
      return component<std::uint16_t>(bytes_, begin + 2 * index, is_normalized);
    case uint32:
      return component<std::uint32_t>(bytes_, begin + 4 * index, is_normalized);
    default:
      return static_cast<double>(number_at<float>(bytes_, begin + 4 * index));
  }
}

GltfAccessor::GltfAccessor(const GltfValue& accessor, GltfBuffers& buffers)
    : count_(accessor.at("count").whole()), components_(components_of(accessor.at("type"))) {
  if (const auto normalized = accessor.find("normalized")) is_normalized_ = normalized->boolean();
  const GltfValue type = accessor.at("componentType");
  const auto sparse = accessor.find("sparse");
  if (!sparse || accessor.find("bufferView")) {
    elements_.emplace(accessor, type, count_, components_, buffers);
  }
  if (!sparse) return;
  const GltfValue indices = sparse->at("indices"), values = sparse->at("values");
  const std::uint64_t replaced = sparse->at("count").whole();
  sparse_ = {indices, GltfElements(indices, indices.at("componentType"), replaced, 1, buffers),
             GltfElements(values, type, replaced, components_, buffers)};
  if (!sparse_->indices.is_unsigned()) throw indices.bad("are no whole numbers");
}

void GltfAccessor::require_order() const {
  if (!sparse_) return;
  double least = 0.0;
  for (std::size_t i = 0; i < sparse_->indices.size(); ++i) {
    const double index = sparse_->indices.at(i, 0, false);
    if (index >= static_cast<double>(count_)) {
      throw sparse_->place.bad(
          fmt::format("refers to element {}, but there are {}, from 0 on", index, count_));
    }
    if (index < least) throw sparse_->place.bad("is not in order");
    least = index + 1.0;
  }
}

bool GltfAccessor::is_unsigned() const {
  return (elements_ ? *elements_ : sparse_->values).is_unsigned();
}

std::size_t GltfAccessor::replaced_before(std::size_t element) const {
  std::size_t begin = 0, end = sparse_->indices.size();
  while (begin < end) {
    const std::size_t middle = begin + (end - begin) / 2;
    const bool is_before = sparse_->indices.at(middle, 0, false) < static_cast<double>(element);
    (is_before ? begin : end) = is_before ? middle + 1 : middle;
  }
  return begin;
}

double GltfAccessor::at(std::size_t element, std::size_t index) const {
  if (sparse_) {
    const std::size_t n = replaced_before(element);
    const bool is_replaced = n < sparse_->indices.size() &&
                             sparse_->indices.at(n, 0, false) == static_cast<double>(element);
    if (is_replaced) return sparse_->values.at(n, index, is_normalized_);
  }
  return elements_ ? elements_->at(element, index, is_normalized_) : 0.0;
}

}  // namespace twrench::mesh

#include "image/png_bounds.h"

#include <fmt/format.h>
#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>

namespace twrench {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t signature = 8;        // bytes before the first chunk
constexpr std::size_t header_end = 8 + 25;  // of IHDR, which comes first

/// Four bytes, the greatest first (PNG specification, 2.1).
std::uint32_t number_at(Bytes file, std::size_t at) {
  std::uint32_t value = 0;
  for (const std::uint8_t byte : file.subspan(at, 4)) value = value << 8U | byte;
  return value;
}

/// PNG specification, 5.3.
struct Chunk {
  static constexpr std::uint32_t data_type = 0x49444154;          // "IDAT"
  static constexpr std::uint32_t end_type = 0x49454E44;           // "IEND"
  static constexpr std::uint32_t transparency_type = 0x74524E53;  // "tRNS"

  Bytes checked;      ///< its type and data
  std::uint32_t sum;  ///< of those

  std::uint32_t type() const { return number_at(checked, 0); }
  Bytes data() const { return checked.subspan(4); }
  std::size_t size() const { return checked.size() + 8; }  ///< in the file
};

/// The chunk that begins there; nothing where it does not end within the file.
std::optional<Chunk> chunk_at(Bytes file, std::size_t at) {
  constexpr std::size_t around = 12;  // a chunk's length, type and checksum
  if (file.size() - at < around) return std::nullopt;
  const std::size_t length = number_at(file, at);
  if (length > file.size() - at - around) return std::nullopt;
  return Chunk{file.subspan(at + 4, length + 4), number_at(file, at + 8 + length)};
}

/// Whether every chunk up to IEND ends within the file. One of data that has none is refused too:
/// legal, but written by nobody, and stb_image copies from a null pointer for it.
bool has_all_chunks(Bytes file) {
  std::size_t at = signature;
  while (const auto chunk = chunk_at(file, at)) {
    if (chunk->type() == Chunk::end_type) return true;
    if (chunk->type() == Chunk::data_type && chunk->data().empty()) return false;
    at += chunk->size();
  }
  return false;
}

/// The compressed data, in as many pieces as they come in, inflated only for their checksum.
class DataCheck {
 public:
  explicit DataCheck(const PngHeader& header) : most_((8 * header.width + 16) * header.height) {
    isal_inflate_init(state_.get());
    state_->crc_flag = ISAL_ZLIB;
  }

  /// False where they are damaged, or more than the pixels can be. What follows their end is left
  /// alone, as decoders do.
  bool add(Bytes data) {
    state_->next_in = const_cast<std::uint8_t*>(data.data());  // it is only read
    state_->avail_in = static_cast<std::uint32_t>(data.size());
    do {
      state_->next_out = dropped_->data();
      state_->avail_out = static_cast<std::uint32_t>(dropped_->size());
      if (isal_inflate(state_.get()) != ISAL_DECOMP_OK) return false;
      size_ += dropped_->size() - state_->avail_out;
      if (size_ > most_) return false;
    } while (!is_complete() && (state_->avail_in > 0 || state_->avail_out == 0));
    return true;
  }

  bool is_complete() const { return state_->block_state == ISAL_BLOCK_FINISH; }

 private:
  // A pixel has at most 8 bytes, a row one for its filter; of the seven passes of an interlaced
  // image, each with rows of its own, 16 bytes a row are more than enough for these.
  std::uint64_t most_;
  std::uint64_t size_ = 0;
  using Room = std::array<std::uint8_t, 1 << 16>;
  std::unique_ptr<inflate_state> state_ = std::make_unique<inflate_state>();
  std::unique_ptr<Room> dropped_ = std::make_unique<Room>();
};

}  // namespace

bool can_be_whole_png(Bytes file) {
  if (file.size() < header_end || !has_all_chunks(file)) return false;
  // A pixel has a bit or more, and deflate makes at best 258 bytes of 2 bits (RFC 1951, 3.2.5).
  constexpr std::uint64_t most_from_a_byte = 1032;
  const PngHeader header = png_header(file);
  return (header.width + 7) / 8 * header.height <= most_from_a_byte * file.size();
}

PngHeader png_header(Bytes file) {
  constexpr std::size_t width_at = signature + 8, height_at = width_at + 4;
  constexpr std::size_t colour_type_at = height_at + 5;
  constexpr unsigned alpha_used = 4;  // PNG specification, 11.2.2
  PngHeader header{number_at(file, width_at), number_at(file, height_at),
                   (file[colour_type_at] & alpha_used) != 0};
  std::size_t at = signature;
  for (auto chunk = chunk_at(file, at); chunk && chunk->type() != Chunk::end_type;
       chunk = chunk_at(file, at += chunk->size())) {
    header.has_alpha = header.has_alpha || chunk->type() == Chunk::transparency_type;
  }
  return header;
}

std::string find_png_damage(Bytes file) {
  DataCheck data(png_header(file));
  bool is_last = false;
  for (std::size_t at = signature; !is_last;) {
    const Chunk chunk = chunk_at(file, at).value();
    if (crc32_gzip_refl(0, chunk.checked.data(), chunk.checked.size()) != chunk.sum) {
      const std::string_view name(reinterpret_cast<const char*>(chunk.checked.data()), 4);
      return fmt::format("the checksum of its chunk {} is wrong", name);
    }
    if (chunk.type() == Chunk::data_type && !data.is_complete() && !data.add(chunk.data())) {
      return "its compressed data are damaged";
    }
    is_last = chunk.type() == Chunk::end_type;
    at += chunk.size();
  }
  return data.is_complete() ? "" : "its compressed data are cut short";
}

}  // namespace twrench

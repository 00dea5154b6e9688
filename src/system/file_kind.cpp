#include "system/file_kind.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <string>

namespace twrench::system {
namespace {

using namespace std::string_view_literals;

/// Bytes at a fixed offset that identify a kind of file.
struct Signature {
  std::string_view kind;
  std::size_t offset;
  std::string_view bytes;
};

constexpr std::array signatures{
    Signature{"a PNG picture", 0, "\x89PNG\r\n\x1A\n"sv},
    Signature{"a JPEG picture", 0, "\xFF\xD8\xFF"sv},
    Signature{"a GIF picture", 0, "GIF87a"sv},
    Signature{"a GIF picture", 0, "GIF89a"sv},
    Signature{"a WebP picture", 8, "WEBPVP8"sv},
    Signature{"a TIFF picture", 0, "II*\0"sv},
    Signature{"a TIFF picture", 0, "MM\0*"sv},
    Signature{"an AVIF picture", 4, "ftypavif"sv},
    Signature{"a HEIC picture", 4, "ftypheic"sv},
    Signature{"a PDF document", 0, "%PDF-"sv},
    Signature{"a PostScript document", 0, "%!PS"sv},
    Signature{"an FBX model", 0, "Kaydara FBX Binary"sv},
    Signature{"an FBX model", 0, "; FBX "sv},
    Signature{"a STEP model", 0, "ISO-10303-21;"sv},
    Signature{"a Blender file", 0, "BLENDER"sv},
    Signature{"a USD model", 0, "PXR-USDC"sv},
    Signature{"a USD model", 0, "#usda "sv},
    Signature{"a VRML model", 0, "#VRML V"sv},
    Signature{"a Rhino model", 0, "3D Geometry File Format "sv},
    Signature{"an AutoCAD drawing", 0, "AC10"sv},
    Signature{"a binary glTF model", 0, "glTF"sv},
    Signature{"a NumPy array", 0, "\x93NUMPY"sv},
    Signature{"an HDF5 file", 0, "\x89HDF\r\n\x1A\n"sv},
    Signature{"a Parquet file", 0, "PAR1"sv},
    Signature{"an SQLite database", 0, "SQLite format 3\0"sv},
    Signature{"a WAV sound", 8, "WAVEfmt "sv},
    Signature{"a FLAC sound", 0, "fLaC"sv},
    Signature{"an Ogg file", 0, "OggS"sv},
    Signature{"an MP3 sound", 0, "ID3"sv},
    Signature{"an MP4 or QuickTime film", 4, "ftyp"sv},
    Signature{"a Matroska or WebM film", 0, "\x1A\x45\xDF\xA3"sv},
    Signature{"a ZIP archive", 0, "PK\3\4"sv},
    Signature{"an empty ZIP archive", 0, "PK\5\6"sv},
    Signature{"a 7z archive", 0, "7z\xBC\xAF\x27\x1C"sv},
    Signature{"a RAR archive", 0, "Rar!\x1A\x07"sv},
    Signature{"a tar archive", 257, "ustar"sv},
    Signature{"compressed by gzip", 0, "\x1F\x8B\x08"sv},
    Signature{"compressed by bzip2", 0, "BZh"sv},
    Signature{"compressed by xz", 0, "\xFD\x37zXZ\0"sv},
    Signature{"compressed by zstd", 0, "\x28\xB5\x2F\xFD"sv},
    Signature{"an executable program", 0, "\x7F\x45LF"sv},
    Signature{"a list of other files", 0, "ffconcat"sv},
    Signature{"a list of other files", 0, "#EXTM3U"sv},
    Signature{"a list of other files", 0, "[playlist]"sv},
    Signature{"a description of a session", 0, "v=0\n"sv},
    Signature{"a description of a session", 0, "v=0\r\n"sv},
    Signature{"a pointer to a file in Git LFS, not the file itself", 0,
              "version https://git-lfs.github.com/"sv},
};

bool has_signature(std::string_view bytes, const Signature& signature) {
  return bytes.size() >= signature.offset &&
         bytes.substr(signature.offset).starts_with(signature.bytes);
}

/// Two letters identify BMP, so its header is checked, too: the reserved bytes and the size of the
/// second header.
bool is_bmp(std::string_view bytes) {
  if (!bytes.starts_with("BM") || bytes.size() < 18) return false;
  const auto size = static_cast<unsigned char>(bytes[14]);
  constexpr std::array<unsigned char, 7> sizes{12, 40, 52, 56, 64, 108, 124};
  return bytes.substr(6, 4) == "\0\0\0\0"sv && bytes.substr(15, 3) == "\0\0\0"sv &&
         std::ranges::find(sizes, size) != sizes.end();
}

/// Returns whether the text begins like UTF-16, with a byte order mark, or without one in a text of
/// ASCII characters.
bool is_utf16(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) return true;
  constexpr std::size_t least = 8, most = 64;
  if (bytes.size() < least) return false;
  const std::size_t zero = bytes[0] == '\0' ? 0 : 1;
  for (std::size_t i = 0; i + 1 < std::min(bytes.size(), most); i += 2) {
    const auto other = static_cast<unsigned char>(bytes[i + 1 - zero]);
    const bool is_text = (std::isprint(other) || std::isspace(other));
    if (bytes[i + zero] != '\0' || !is_text) return false;
  }
  return true;
}

/// Returns the beginning of a text in lower case, without a byte order mark and white space.
std::string beginning_of(std::string_view bytes) {
  bytes = without_byte_order_mark(bytes);
  bytes.remove_prefix(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
  std::string text(bytes.substr(0, 16));
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

std::optional<std::string_view> recognized_file_kind(std::string_view bytes) {
  if (bytes.empty()) return "empty";
  if (is_utf16(bytes)) return "text in UTF-16, not in UTF-8";
  if (is_bmp(bytes)) return "a BMP picture";
  const auto has_it = [&](const Signature& signature) { return has_signature(bytes, signature); };
  const auto* const found = std::ranges::find_if(signatures, has_it);
  if (found != signatures.end()) {
    const bool is_3mf = bytes.starts_with("PK") && bytes.find("3dmodel.model") != bytes.npos;
    return is_3mf ? "a 3MF model, which is a ZIP archive" : found->kind;
  }
  const std::string text = beginning_of(bytes);
  if (text.starts_with("<!doctype html") || text.starts_with("<html")) return "an HTML page";
  if (text.starts_with("<?xml")) return "an XML document";
  if (text.starts_with("<svg")) return "an SVG picture";
  return {};
}

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

}  // namespace twrench::system

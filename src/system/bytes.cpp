#include "system/bytes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace twrench::system {

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t piece = 3U << 20U;  // fits OpenSSL's int; pieces need no padding
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');  // and OpenSSL's terminating zero
  std::size_t size = 0;
  for (; !bytes.empty(); bytes = bytes.subspan(std::min(piece, bytes.size()))) {
    size += static_cast<std::size_t>(
        EVP_EncodeBlock(reinterpret_cast<unsigned char*>(&text[size]), bytes.data(),
                        static_cast<int>(std::min(piece, bytes.size()))));
  }
  text.resize(size);
  return text;
}

std::optional<std::vector<std::uint8_t>> bytes_of_base64(std::string_view text) {
  constexpr std::size_t piece = 4U << 20U;  // OpenSSL counts in int
  if (text.size() % 4 != 0) return {};
  const std::size_t padding = text.ends_with("==") ? 2 : text.ends_with('=') ? 1 : 0;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(text.size() / 4 * 3);
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view part = rest.substr(0, piece);
    rest.remove_prefix(part.size());
    // OpenSSL skips blanks at the ends, and reads padding inside as zeros.
    const std::string_view digits = part.substr(0, part.size() - (rest.empty() ? padding : 0));
    if (std::ranges::any_of(digits, [](char c) { return c == '=' || c <= ' '; })) return {};
    const std::size_t before = bytes.size();
    bytes.resize(before + part.size() / 4 * 3);
    if (EVP_DecodeBlock(bytes.data() + before, reinterpret_cast<const unsigned char*>(part.data()),
                        static_cast<int>(part.size())) < 0) {
      return {};
    }
  }
  bytes.resize(bytes.size() - padding);
  return bytes;
}

std::string sha256_hex(std::span<const std::uint8_t> bytes) {
  std::array<std::uint8_t, 32> digest{};
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), nullptr, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("OpenSSL has no SHA-256");
  }
  return fmt::format("{:02x}", fmt::join(digest, ""));
}

}  // namespace twrench::system

#include "system/base64.h"

#include <openssl/evp.h>

#include <algorithm>

namespace twrench::system {

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t piece = 3U << 20U;  // OpenSSL counts in int; no padding within
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');  // and OpenSSL's own zero
  std::size_t size = 0;
  for (; !bytes.empty(); bytes = bytes.subspan(std::min(piece, bytes.size()))) {
    size += static_cast<std::size_t>(
        EVP_EncodeBlock(reinterpret_cast<unsigned char*>(&text[size]), bytes.data(),
                        static_cast<int>(std::min(piece, bytes.size()))));
  }
  text.resize(size);
  return text;
}

}  // namespace twrench::system

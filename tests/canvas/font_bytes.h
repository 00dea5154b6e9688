#pragma once

#include <hb-subset.h>

#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "system/file.h"

namespace twrench::canvas {

/// The file of "sans", from its package.
inline std::vector<std::uint8_t> sans_file() {
  return system::read_file(TWRENCH_SANS_FILE, 1 << 24);
}

/// The file of a typeface with Latin, Greek, Arabic, Hebrew, Devanagari and more.
inline std::vector<std::uint8_t> many_scripts_file() {
  return system::read_file(TWRENCH_MANY_SCRIPTS_FILE, 1 << 24);
}

/// The same with these characters only.
inline std::vector<std::uint8_t> many_scripts_file(std::u32string_view characters) {
  const std::vector<std::uint8_t> file = many_scripts_file();
  const std::unique_ptr<hb_blob_t, decltype(&hb_blob_destroy)> blob(
      hb_blob_create(reinterpret_cast<const char*>(file.data()), static_cast<unsigned>(file.size()),
                     HB_MEMORY_MODE_READONLY, nullptr, nullptr),
      &hb_blob_destroy);
  const std::unique_ptr<hb_face_t, decltype(&hb_face_destroy)> face(hb_face_create(blob.get(), 0),
                                                                    &hb_face_destroy);
  const std::unique_ptr<hb_subset_input_t, decltype(&hb_subset_input_destroy)> input(
      hb_subset_input_create_or_fail(), &hb_subset_input_destroy);
  for (const char32_t c : characters) hb_set_add(hb_subset_input_unicode_set(input.get()), c);
  const std::unique_ptr<hb_face_t, decltype(&hb_face_destroy)> subset(
      hb_subset_or_fail(face.get(), input.get()), &hb_face_destroy);
  if (!subset) throw std::runtime_error("HarfBuzz makes no subset of the font");
  const std::unique_ptr<hb_blob_t, decltype(&hb_blob_destroy)> bytes(
      hb_face_reference_blob(subset.get()), &hb_blob_destroy);
  unsigned size = 0;
  const char* data = hb_blob_get_data(bytes.get(), &size);
  return {data, data + size};
}

/// The bytes of a table in the file.
inline std::span<std::uint8_t> table(std::vector<std::uint8_t>& file, const std::string& tag) {
  const auto number = [&](std::size_t at) {
    std::size_t value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = value << 8U | file[i];
    return value;
  };
  std::size_t at = 12;
  while (std::string(&file[at], &file[at + 4]) != tag) at += 16;
  return std::span(file).subspan(number(at + 8), number(at + 12));
}

}  // namespace twrench::canvas

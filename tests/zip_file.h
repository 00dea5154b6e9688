#pragma once

#include <gtest/gtest.h>
#include <zip.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "scratch_folder.h"

namespace twrench {

struct NamedFile {
  std::string name, bytes;
};

/// Returns the bytes of a ZIP archive of these files, after `change` was applied to it.
inline std::string archive_of(
    const std::vector<NamedFile>& files,
    const std::function<void(zip_t*)>& change = [](zip_t*) {}) {
  const ScratchFolder folder;
  const std::filesystem::path path = folder / "a.zip";
  zip_t* archive = zip_open(path.c_str(), ZIP_CREATE, nullptr);
  for (const NamedFile& file : files) {
    zip_source_t* source = zip_source_buffer(archive, file.bytes.data(), file.bytes.size(), 0);
    zip_file_add(archive, file.name.c_str(), source, 0);
  }
  change(archive);
  EXPECT_EQ(zip_close(archive), 0);
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Encrypts the first file of an archive.
inline void encrypt(zip_t* archive) {
  zip_file_set_encryption(archive, 0, ZIP_EM_AES_256, "password");
}

/// Stores the first file of an archive without compression.
inline void store(zip_t* archive) { zip_set_file_compression(archive, 0, ZIP_CM_STORE, 0); }

}  // namespace twrench

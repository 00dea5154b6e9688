#pragma once

#include <filesystem>

namespace twrench::torture {

/// Fills the empty folder with what command lines may name: scenes, pictures and folders of frames,
/// sound and broken, links, names that are hard to print. `twrench` draws the frames. Throws
/// std::runtime_error where it cannot.
void furnish(const std::filesystem::path& folder, const std::filesystem::path& twrench);

/// A copy of such a folder, with what cannot be copied: FIFOs, and what may not be read or entered.
void copy_playground(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace twrench::torture

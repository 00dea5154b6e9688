#pragma once

#include <span>
#include <string>

namespace twrench::page {

/// A page as the index of a site shows it.
struct SiteEntry {
  /// The file beside the index.
  std::string file;
  std::string title;
  std::string description;
  /// An <img> element, or empty.
  std::string poster;
};

/// Returns the index of a folder of pages: a link to each, with its picture. It makes no network
/// requests.
std::string site_html(std::span<const SiteEntry> pages);

}  // namespace twrench::page

#pragma once

#include <string>
#include <string_view>

namespace twrench::page {

/// Replaces the marks of a template by texts, in their order.
class TemplateFilling {
 public:
  explicit TemplateFilling(std::string_view text) : rest_(text) {}

  /// Throws FileError if the mark is missing or out of order.
  void put(std::string_view mark, std::string_view text);

  std::string filled() && { return std::move(filled_.append(rest_)); }

 private:
  std::string_view rest_;
  std::string filled_;
};

}  // namespace twrench::page

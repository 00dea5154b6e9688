#pragma once

#include <optional>
#include <string_view>

namespace twrench::system {

/// Returns the kind of a file, identified by its first bytes, to complete the sentence "it is ...":
/// "a JPEG picture", "empty", "text in UTF-16, not in UTF-8". Nothing if the kind is unknown. The
/// kinds that a reader supports are recognised, too, so it must rule out its own format first. 4096
/// bytes suffice, except that a 3MF model is a ZIP archive unless the bytes include a name in it.
std::optional<std::string_view> recognized_file_kind(std::string_view bytes);

/// Returns the text without the UTF-8 byte order mark that some programs write before it.
std::string_view without_byte_order_mark(std::string_view text);

}  // namespace twrench::system

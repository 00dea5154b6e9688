#include "page/template_filling.h"

#include <fmt/format.h>

#include "system/error.h"

namespace twrench::page {

void TemplateFilling::put(std::string_view mark, std::string_view text) {
  const std::size_t at = rest_.find(mark);
  if (at == std::string_view::npos) {
    throw system::FileError("page template",
                            fmt::format("the mark {} is missing or out of order", mark));
  }
  filled_.append(rest_.substr(0, at)).append(text);
  rest_.remove_prefix(at + mark.size());
}

}  // namespace twrench::page

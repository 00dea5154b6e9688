#include "base/argument.h"

namespace twrench {
namespace {

// Control characters, which no text of ours contains otherwise.
constexpr char begins = '\x02', separates = '\x1f', ends = '\x03';

}  // namespace

std::string argument(std::string_view name, std::string_view value) {
  std::string mention{begins};
  mention.append(name).append(1, separates).append(value).append(1, ends);
  return mention;
}

std::string with_arguments(std::string_view text, const ArgumentWording& wording) {
  std::string worded;
  std::size_t begin = 0;
  while ((begin = text.find(begins)) != std::string_view::npos) {
    const std::size_t middle = text.find(separates, begin), end = text.find(ends, begin);
    if (end == std::string_view::npos || middle > end) break;
    worded.append(text.substr(0, begin));
    worded += wording(text.substr(begin + 1, middle - begin - 1),
                      text.substr(middle + 1, end - middle - 1));
    text.remove_prefix(end + 1);
  }
  return worded.append(text);
}

}  // namespace twrench

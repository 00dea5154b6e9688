#include "table/opensim_quaternions.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/words.h"
#include "table/dialect.h"
#include "table/line_reader.h"
#include "table/number_text.h"

namespace twrench::table {

bool has_quaternion_cells(std::string_view start) {
  const std::string lines = to_lower(start);
  const std::size_t end = lines.find("endheader");
  return end != std::string::npos && lines.find("datatype=quaternion") < end;
}

Input table_of_quaternions(const Input& input) {
  auto text = std::make_shared<std::string>();
  bool is_below_header = false, has_names = false;
  LineReader lines(input);
  for (std::string_view line; lines.next(line);) {
    if (!is_below_header) {
      is_below_header = to_lower(trimmed(line)) == "endheader";
      *text += '#';
      *text += line;
    } else if (!has_names) {
      std::vector<std::string_view> names;
      split_cells(line, '\t', names);
      *text += names.front();
      for (std::size_t i = 1; i < names.size(); ++i) {
        for (const char* component : {".qw", ".qx", ".qy", ".qz"}) {
          *text += '\t';
          *text += names[i];
          *text += component;
        }
      }
      has_names = true;
    } else {
      std::ranges::replace_copy(line, std::back_inserter(*text), ',', '\t');
    }
    *text += '\n';
  }
  return {input.name(), std::shared_ptr<const std::string>(std::move(text))};
}

}  // namespace twrench::table

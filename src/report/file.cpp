#include "report/file.h"

#include <twrench/base/error.h>

#include <filesystem>

#include "report/markdown.h"
#include "system/output.h"

namespace twrench::report {

bool is_markdown(const std::string& file) {
  const std::string ending = std::filesystem::path(file).extension().string();
  if (ending == ".md") return true;
  if (ending == ".html" || file == "-") return false;
  throw InvalidArgument("report " + file, "its name must end in .html or .md");
}

void write_report(const std::string& file, const Document& document, const Viewer* viewer) {
  const bool markdown = is_markdown(file);
  system::Output output(file);
  const Write write = [&](std::string_view text) { output.write(text); };
  const std::filesystem::path path(file);
  Figures figures;
  if (markdown) {
    figures = write_markdown(document, path.parent_path(), path.stem().string(), write);
  } else {
    write_html(document, viewer, write);
  }
  // All data is on the disk before the first file appears.
  output.finish();
  for (const auto& figure : figures) figure->commit();
}

}  // namespace twrench::report

#include "report/file.h"

#include "report/markdown.h"
#include "system/output.h"

namespace twrench::report {

void write_report(const system::OutputFile& file, const Document& document, const Viewer* viewer,
                  system::FileList& files) {
  const bool markdown = file.format().name == "markdown";
  const FigureFiles figure_files =
      markdown ? files_of_figures(document, file, files) : FigureFiles();
  system::Output output(file);
  const Write write = [&](std::string_view text) { output.write(text); };
  Figures figures;
  if (markdown) {
    figures = write_markdown(document, figure_files, write);
  } else {
    write_html(document, viewer, write);
  }
  // All data is on the disk before the first file appears.
  output.finish();
  for (const auto& figure : figures) figure->commit();
}

}  // namespace twrench::report

#include "report/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <memory>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "system/output.h"

namespace twrench::report {
namespace {

/// The files of a document's figures, in their order.
using FigureFiles = std::vector<system::OutputFile>;

/// Complete files of figures, which appear once they are committed.
using Figures = std::vector<std::unique_ptr<system::PendingFile>>;

/// Escapes the characters that Markdown reads as markup.
std::string markdown(std::string_view text) {
  constexpr std::string_view special = "\\`*_[]<>|#&$~^{}";
  std::string result;
  for (const char c : text) {
    if (special.find(c) != std::string_view::npos) result += '\\';
    result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return result;
}

/// Indented, so that nothing in it is markup.
std::string command_markdown(const std::vector<std::string>& commands) {
  std::string lines = "\n";
  for (std::string command : commands) {
    std::ranges::replace(command, '\n', ' ');
    lines += "    " + command + "\n";
  }
  return lines + "\n";
}

std::string line_of(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line.append(" ").append(markdown(cell)).append(" |");
  return line + "\n";
}

/// A file name as the destination of a link.
std::string link_destination(std::string_view file) {
  std::string result;
  for (const char c : file) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = std::isalnum(byte) != 0 || c == '-' || c == '.' || c == '_';
    result += is_plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return result;
}

/// Writes the parts of a section.
class MarkdownWriter {
 public:
  MarkdownWriter(Language language, const FigureFiles& files, const Write& write)
      : language_(language), files_(files), write_(write) {}

  void operator()(const Paragraph& paragraph) { write_(markdown(paragraph.text) + "\n\n"); }

  void operator()(const Subheading& heading) { write_("### " + markdown(heading.text) + "\n\n"); }

  void operator()(const Table& table) {
    write_(fmt::format("**{}** {}\n\n{}|", table_number.in(language_, ++tables_),
                       markdown(table.caption), line_of(table.header)));
    for (std::size_t i = 0; i < table.header.size(); ++i) {
      write_(i < table.text_columns ? "---|" : "---:|");
    }
    write_("\n");
    for (const auto& row : table.rows) write_(line_of(row));
    write_(command_markdown(table.commands));
  }

  void operator()(const Figure& figure) {
    const system::OutputFile& file = files_[pending_.size()];
    pending_.push_back(plot::draw_pending_plot(file, figure.plot));
    write_(fmt::format("![{0}]({1})\n\n**{2}** {0}\n{3}", markdown(figure.caption),
                       link_destination(file.path().filename().string()),
                       figure_number.in(language_, pending_.size()),
                       command_markdown({figure.command})));
  }

  void operator()(const Formula& formula) {
    write_(fmt::format("$$\n{} \\tag{{{}}}\n$$\n\n{}\n\n", formula.tex, ++formulas_,
                       markdown(formula.says)));
  }

  void operator()(const List& list) {
    int number = 0;
    for (const std::string& item : list.items) {
      write_(fmt::format("{}. {}\n", ++number, markdown(item)));
    }
    write_("\n");
  }

  /// The files of the figures, complete but not yet committed.
  Figures figures() && { return std::move(pending_); }

 private:
  Language language_;
  const FigureFiles& files_;
  const Write& write_;
  int tables_ = 0, formulas_ = 0;
  Figures pending_;
};

/// Returns files beside the report, and adds them to `files`. Throws OverwriteError.
FigureFiles files_of_figures(const Document& document, const system::OutputFile& report,
                             system::FileList& files) {
  const std::filesystem::path folder = report.path().parent_path();
  const std::string stem = report.path().stem().string();
  FigureFiles figures;
  std::set<std::string> names;
  for (const Section& section : document.sections) {
    for (const auto& part : section.content) {
      const Figure* const figure = std::get_if<Figure>(&part);
      if (figure == nullptr) continue;
      // Two scenes may have the same name.
      std::string name = fmt::format("{}-{}.svg", stem, figure->name);
      for (int n = 2; !names.insert(name).second; ++n) {
        name = fmt::format("{}-{}-{}.svg", stem, figure->name, n);
      }
      figures.push_back(files.add_output(system::plot_output, folder / name));
    }
  }
  return figures;
}

/// Writes the document as Markdown with TeX formulas. Returns its plots as SVG files; commit them
/// once the document is written, so that either all of it appears or nothing. Throws PlotError and
/// FileError.
Figures write_markdown(const Document& document, const FigureFiles& files, const Write& write) {
  write(fmt::format("# {}\n\n", markdown(document.title)));
  const Language language = document.language;
  if (!document.author.empty()) {
    write(Phrase("Author: ", "Forfatter: ").in(language) + markdown(document.author) + "\n\n");
  }
  if (!document.date.empty()) {
    write(Phrase("Date: ", "Dato: ").in(language) + markdown(document.date) + "\n\n");
  }
  write(markdown(document.program) + "\n" + command_markdown({document.command}));
  MarkdownWriter writer(language, files, write);
  for (const Section& section : document.sections) {
    write("## " + markdown(section.heading) + "\n\n");
    for (const auto& part : section.content) std::visit(writer, part);
  }
  return std::move(writer).figures();
}

}  // namespace

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

#include "report/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <memory>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/enumeration.h"
#include "embedded/report_files.h"
#include "text/escape.h"

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

namespace {

/// The text as content of an element or of an attribute.
std::string html(std::string_view text) {
  std::string shown(text);
  std::erase_if(shown, [](unsigned char c) { return c < 0x20 && c != '\n'; });
  return text::with_references(shown);
}

std::string command_html(const std::string& command) {
  return "<code class=\"command\">" + html(command) + "</code>";
}

/// Gives the names in an SVG a prefix, because all figures of a page share their names, and removes
/// its fixed size and its title.
std::string inline_svg(std::string svg, const std::string& prefix) {
  svg.erase(0, svg.find("<svg"));
  for (const std::string_view before : {"id='", "id=\"", "href='#", "href=\"#", "url(#"}) {
    for (std::size_t at = 0; (at = svg.find(before, at)) != std::string::npos;) {
      at += before.size();
      svg.insert(at, prefix);
    }
  }
  const std::size_t size = svg.find("width="), end = svg.find("viewBox=");
  if (size < end && end != std::string::npos) svg.erase(size, end - size);
  const std::size_t title = svg.find("<title>"), after = svg.find("</desc>");
  if (title < after && after != std::string::npos) svg.erase(title, after + 7 - title);
  return svg;
}

/// Writes the parts of a section.
class HtmlWriter {
 public:
  HtmlWriter(Language language, const Write& write) : language_(language), write_(write) {}

  void operator()(const Paragraph& paragraph) { write_("<p>" + html(paragraph.text) + "</p>\n"); }

  void operator()(const Subheading& heading) { write_("<h3>" + html(heading.text) + "</h3>\n"); }

  void operator()(const Table& table) {
    write_(
        fmt::format("<figure class=\"table\"><table>\n<caption><b>{}</b> {}</caption>\n<thead><tr>",
                    table_number.in(language_, ++tables_), html(table.caption)));
    const auto align = [&](std::size_t i) {
      return i < table.text_columns ? " class=\"words\"" : "";
    };
    for (std::size_t i = 0; i < table.header.size(); ++i) {
      write_(fmt::format("<th scope=\"col\"{}>{}</th>", align(i), html(table.header[i])));
    }
    write_("</tr></thead>\n<tbody>\n");
    for (const auto& row : table.rows) {
      write_(fmt::format("<tr><th scope=\"row\"{}>{}</th>", align(0), html(row.front())));
      for (std::size_t i = 1; i < row.size(); ++i) {
        write_(fmt::format("<td{}>{}</td>", align(i), html(row[i])));
      }
      write_("</tr>\n");
    }
    write_("</tbody></table>\n");
    for (const std::string& command : table.commands) write_(command_html(command));
    write_("</figure>\n");
  }

  void operator()(const Figure& figure) {
    ++figures_;
    write_(fmt::format("<figure role=\"group\" aria-label=\"{}\">\n", html(figure.caption)));
    write_(inline_svg(plot::svg(figure.plot), fmt::format("figure{}-", figures_)));
    write_(fmt::format("<figcaption><b>{}</b> {}</figcaption>\n{}</figure>\n",
                       figure_number.in(language_, figures_), html(figure.caption),
                       command_html(figure.command)));
  }

  void operator()(const Formula& formula) {
    write_(
        fmt::format("<div class=\"formula\"><math display=\"block\">{}</math><span>({})</span>"
                    "<p>{}</p></div>\n",
                    formula.mathml, ++formulas_, html(formula.says)));
  }

  void operator()(const List& list) {
    write_("<ol>\n");
    for (const std::string& item : list.items) write_("<li>" + html(item) + "</li>\n");
    write_("</ol>\n");
  }

 private:
  Language language_;
  const Write& write_;
  int tables_ = 0, figures_ = 0, formulas_ = 0;
};

constexpr const char* own_policy =
    "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
    "'unsafe-inline'; img-src data:\">";

/// The author and the date, as far as they are given.
std::string byline(const Document& document) {
  std::string lines;
  for (const std::string& text : {document.author, document.date}) {
    if (!text.empty()) lines += "<p class=\"byline\">" + html(text) + "</p>\n";
  }
  return lines;
}

void write_head(const Document& document, const Viewer* viewer, const Write& write) {
  write(
      fmt::format("<!doctype html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n{}\n"
                  "<meta name=\"viewport\" content=\"width=device-width\">\n"
                  "<meta name=\"generator\" content=\"{}\">\n",
                  enumerator_name(document.language), viewer ? viewer->policy : own_policy,
                  html(document.program)));
  if (!document.author.empty()) {
    write(fmt::format("<meta name=\"author\" content=\"{}\">\n", html(document.author)));
  }
  write(fmt::format(
      "<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n<main>\n<header>\n<h1>{}</h1>\n"
      "{}<p>{}</p>\n{}</header>\n",
      html(document.title), embedded::report_files().at("report.css"), html(document.title),
      byline(document), html(document.program), command_html(document.command)));
}

}  // namespace

Formula formula(std::string_view name, std::string says) {
  std::istringstream lines{std::string(embedded::report_files().at("formulas.txt"))};
  std::string title, tex, mathml, blank;
  while (std::getline(lines, title) && std::getline(lines, tex) && std::getline(lines, mathml)) {
    if (title == name) return {tex, mathml, std::move(says)};
    std::getline(lines, blank);
  }
  throw std::logic_error(fmt::format("there is no formula '{}'", name));
}

void write_html(const Document& document, const Viewer* viewer, const Write& write) {
  write_head(document, viewer, write);
  if (viewer != nullptr) {
    write("<div class=\"viewer\">" + viewer->poster + "<iframe title=\"" +
          Phrase("The motion", "Bevegelsen").in(document.language) +
          "\" sandbox=\"allow-scripts allow-downloads\" allow=\"clipboard-write\" srcdoc=\"");
    write(html(viewer->page));
    write("\"></iframe></div>\n");
  }
  HtmlWriter writer(document.language, write);
  for (const Section& section : document.sections) {
    write("<section>\n<h2>" + html(section.heading) + "</h2>\n");
    for (const auto& part : section.content) std::visit(writer, part);
    write("</section>\n");
  }
  write("</main>\n</body>\n</html>\n");
}

}  // namespace twrench::report

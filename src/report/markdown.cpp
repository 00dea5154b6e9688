#include "report/markdown.h"

#include <fmt/format.h>

#include <string_view>

namespace twrench::report {
namespace {

/// The text with what Markdown would read as markup escaped.
std::string markdown(std::string_view text) {
  constexpr std::string_view special = "\\`*_[]<>|#&";
  std::string result;
  for (const char c : text) {
    if (special.find(c) != std::string_view::npos) result += '\\';
    result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return result;
}

/// Indented, so that nothing in it is markup.
std::string command_markdown(std::string command) {
  for (char& c : command) c = c == '\n' ? ' ' : c;
  return "\n    " + command + "\n\n";
}

std::string line_of(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line.append(" ").append(markdown(cell)).append(" |");
  return line + "\n";
}

/// Writes the parts of a section.
class MarkdownWriter {
 public:
  MarkdownWriter(const std::filesystem::path& folder, const std::string& stem, const Write& write)
      : folder_(folder), stem_(stem), write_(write) {}

  void operator()(const Table& table) {
    write_(fmt::format("**Table {}.** {}\n\n{}|", ++tables_, markdown(table.caption),
                       line_of(table.header)));
    for (std::size_t i = 0; i < table.header.size(); ++i) write_("---|");
    write_("\n");
    for (const auto& row : table.rows) write_(line_of(row));
    write_(command_markdown(table.command));
  }

  void operator()(const Figure& figure) {
    const std::string file = fmt::format("{}-{}.svg", stem_, figure.name);
    plot::draw_plot((folder_ / file).string(), figure.plot);
    write_(fmt::format("![{0}](<{1}>)\n\n**Figure {2}.** {0}\n{3}", markdown(figure.caption), file,
                       ++figures_, command_markdown(figure.command)));
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

 private:
  const std::filesystem::path& folder_;
  const std::string& stem_;
  const Write& write_;
  int tables_ = 0, figures_ = 0, formulas_ = 0;
};

}  // namespace

void write_markdown(const Document& document, const std::filesystem::path& folder,
                    const std::string& stem, const Write& write) {
  write(fmt::format("# {}\n\n{}\n{}", markdown(document.title), markdown(document.program),
                    command_markdown(document.command)));
  MarkdownWriter writer(folder, stem, write);
  for (const Section& section : document.sections) {
    write("## " + markdown(section.heading) + "\n\n");
    for (const auto& part : section.content) std::visit(writer, part);
  }
}

}  // namespace twrench::report

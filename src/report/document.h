#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "plot/gnuplot.h"
#include "scene/phrase.h"

namespace twrench::report {

using scene::Language;
using scene::Phrase;

/// A paragraph of plain text.
struct Paragraph {
  std::string text;
};

/// A heading within a section.
struct Subheading {
  std::string text;
};

/// A table. Its texts are plain; the first column names the rows.
struct Table {
  std::string caption;                         ///< Its title.
  std::vector<std::string> commands;           ///< The command lines that print these numbers.
  std::vector<std::string> header;             ///< With units.
  std::vector<std::vector<std::string>> rows;  ///< Each as long as the header.
  std::size_t text_columns = 1;  ///< The number of columns of words; those of numbers follow.
};

/// A plot.
struct Figure {
  std::string name;     ///< Its file name without the ending, if it gets a separate file.
  std::string caption;  ///< Its title.
  std::string command;  ///< The command line that draws it.
  plot::Plot plot;      ///< The plot itself.
};

/// A numbered equation.
struct Formula {
  std::string tex, mathml;
  std::string says;  ///< The meaning of its symbols, and its source.
};

/// Returns the formula with that name in formulas.txt. A formula has three lines there: its name,
/// the formula in TeX, and the content of <math>.
Formula formula(std::string_view name, std::string says);

/// A list, as of references.
struct List {
  std::vector<std::string> items;
};

/// A part of a document under a heading.
struct Section {
  std::string heading;
  std::vector<std::variant<Paragraph, Subheading, Table, Figure, Formula, List>> content;
};

/// The labels of tables and figures, with their numbers.
inline constexpr Phrase table_number{"Table {}.", "Tabell {}."};
inline constexpr Phrase figure_number{"Figure {}.", "Figur {}."};

/// A report, independent of the format of its file.
struct Document {
  Language language = Language::en;  ///< The language of all its texts.
  std::string title;
  std::string author;   ///< May be empty.
  std::string date;     ///< May be empty.
  std::string command;  ///< The command line that made it.
  std::string program;  ///< The program and its version.
  std::vector<Section> sections;
};

}  // namespace twrench::report

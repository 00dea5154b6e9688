#pragma once

#include <string>
#include <variant>
#include <vector>

#include "plot/gnuplot.h"

namespace twrench::report {

/// A table. Its texts are plain; the first column names the rows.
struct Table {
  std::string caption;                         ///< What it shows.
  std::string command;                         ///< The command line that prints these numbers.
  std::vector<std::string> header;             ///< With units.
  std::vector<std::vector<std::string>> rows;  ///< Each as long as the header.
};

/// A plot.
struct Figure {
  std::string name;     ///< Of its file, without the ending, where it has one of its own.
  std::string caption;  ///< What it shows.
  std::string command;  ///< The command line that draws it.
  plot::Plot plot;      ///< The plot itself.
};

/// A numbered equation.
struct Formula {
  std::string mathml;  ///< The content of <math>.
  std::string tex;     ///< The same for Markdown.
  std::string says;    ///< What its letters are and where it is from.
};

/// A list, as of references.
struct List {
  std::vector<std::string> items;
};

/// A part of a document under a heading.
struct Section {
  std::string heading;
  std::vector<std::variant<Table, Figure, Formula, List>> content;
};

/// Results as they are read, whatever the format.
struct Document {
  std::string title;
  std::string command;  ///< The command line that made it.
  std::string program;  ///< The program and its version.
  std::vector<Section> sections;
};

}  // namespace twrench::report

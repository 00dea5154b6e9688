#include "report/mathml.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <stdexcept>
#include <utility>

namespace twrench::report {
namespace {

/// The MathML of a TeX command without arguments.
struct Symbol {
  std::string_view name, element, text;
};

constexpr auto math_symbols = std::to_array<Symbol>({
    {"omega", "mi", "ω"},     {"Omega", "mi", "Ω"},     {"lambda", "mi", "λ"},
    {"varphi", "mi", "φ"},    {"theta", "mi", "θ"},     {"pi", "mi", "π"},
    {"rho", "mi", "ρ"},       {"tau", "mi", "τ"},       {"cdot", "mo", "·"},
    {"times", "mo", "×"},     {"sum", "mo", "∑"},       {"int", "mo", "∫"},
    {"dots", "mo", "…"},      {"le", "mo", "≤"},        {"ge", "mo", "≥"},
    {"to", "mo", "→"},        {"approx", "mo", "≈"},    {"|", "mo", "‖"},
    {",", "mspace", ".17em"}, {";", "mspace", ".28em"}, {"quad", "mspace", "1em"},
});

constexpr std::array<std::string_view, 5> math_functions{"cos", "sin", "cot", "exp", "ln"};

constexpr std::string_view thin_space = "<mspace width=\".17em\"/>";

std::string element(std::string_view name, std::string_view content) {
  return fmt::format("<{0}>{1}</{0}>", name, content);
}

/// An operator that keeps its size beside a fraction. Bars and slashes get no space around them.
std::string math_operator(std::string_view text) {
  const bool is_close = text == "|" || text == "‖" || text == "/";
  return fmt::format("<mo stretchy=\"false\"{}>{}</mo>",
                     is_close ? " lspace=\"0\" rspace=\"0\"" : "", text);
}

/// Whether the text ends with an operand. After one, a minus is not a sign, and the name of a
/// function needs space.
bool ends_with_operand(std::string_view before) {
  if (before.empty()) return false;
  const char last = before.back();
  return std::isalnum(static_cast<unsigned char>(last)) != 0 || last == ')' || last == '}' ||
         last == '\'' || last == '|';
}

/// Replaces blanks with no-break spaces, because MathML drops blanks at the ends of a text.
std::string with_hard_spaces(std::string_view text) {
  std::string result;
  for (const char c : text) result += c == ' ' ? std::string("\u00a0") : std::string(1, c);
  return result;
}

/// A recursive-descent parser.
class TexReader {
 public:
  explicit TexReader(std::string_view tex) : rest_(tex) {}

  /// Reads up to the given ending, which stays unread, or to the end of a group, a cell or the
  /// text.
  std::string row(std::string_view ending = {}) {
    std::string content;
    const char* const begin = rest_.data();
    for (skip_blanks(); !rest_.empty(); skip_blanks()) {
      if (rest_.front() == '}' || rest_.front() == '&' || rest_.starts_with("\\\\")) break;
      if (!ending.empty() && rest_.starts_with(ending)) break;
      std::string_view before(begin, static_cast<std::size_t>(rest_.data() - begin));
      while (before.ends_with(' ')) before.remove_suffix(1);
      content += term(ends_with_operand(before));
    }
    return content;
  }

  bool at_end() const { return rest_.empty(); }

 private:
  [[noreturn]] void fail() const {
    throw std::invalid_argument(fmt::format("no MathML for \"{}\"", rest_));
  }
  void skip_blanks() {
    while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
  }
  bool take(std::string_view text) {
    if (!rest_.starts_with(text)) return false;
    rest_.remove_prefix(text.size());
    return true;
  }
  void expect(std::string_view text) {
    if (!take(text)) fail();
  }

  std::string group() {
    expect("{");
    std::string content = row();
    expect("}");
    return element("mrow", content);
  }
  /// Text within braces, as it is.
  std::string_view braced() {
    expect("{");
    const std::size_t end = rest_.find('}');
    if (end == std::string_view::npos) fail();
    const std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return text;
  }
  std::string argument() { return rest_.starts_with("{") ? group() : atom(); }

  /// An atom with its scripts; functions get the space that TeX gives them.
  std::string term(bool after_operand) {
    if (!after_operand && take("-")) return "<mo form=\"prefix\" stretchy=\"false\">−</mo>";
    for (const std::string_view name : math_functions) {
      if (!rest_.starts_with("\\") || !rest_.substr(1).starts_with(name)) continue;
      rest_.remove_prefix(1 + name.size());
      const std::string function = with_scripts(element("mi", name));
      skip_blanks();
      const bool is_fenced = rest_.starts_with("(") || rest_.starts_with("\\left");
      return fmt::format("{}{}{}", after_operand ? thin_space : "", function,
                         is_fenced ? "" : thin_space);
    }
    return with_scripts(atom());
  }

  std::string with_scripts(std::string base) {
    // The character itself is raised.
    while (take("'")) base = element("mrow", base + R"(<mo lspace="0" rspace="0">′</mo>)");
    std::string sub, super;
    while (true) {
      if (take("_")) {
        sub = argument();
      } else if (take("^")) {
        super = argument();
      } else {
        break;
      }
    }
    if (!sub.empty() && !super.empty()) return element("msubsup", base + sub + super);
    if (!sub.empty()) return element("msub", base + sub);
    return super.empty() ? base : element("msup", base + super);
  }

  std::string atom() {
    const auto c = static_cast<unsigned char>(rest_.front());
    if (c == '{') return group();
    if (c == '\\') return command();
    if (std::isdigit(c) != 0) {
      const std::size_t end = std::min(rest_.find_first_not_of("0123456789."), rest_.size());
      const std::string_view digits = rest_.substr(0, end);
      rest_.remove_prefix(end);
      return element("mn", digits);
    }
    rest_.remove_prefix(1);
    if (std::isalpha(c) != 0) return element("mi", std::string(1, static_cast<char>(c)));
    if (c == '-') return math_operator("−");
    if (c == '<') return math_operator("&lt;");
    return math_operator(std::string(1, static_cast<char>(c)));
  }

  std::string command() {
    expect("\\");
    std::size_t length = 0;
    while (length < rest_.size() && std::isalpha(static_cast<unsigned char>(rest_[length])) != 0)
      ++length;
    const std::string_view name = rest_.substr(0, std::max<std::size_t>(length, 1));
    for (const Symbol& symbol : math_symbols) {
      if (symbol.name != name) continue;
      rest_.remove_prefix(name.size());
      if (symbol.element == "mspace") return fmt::format("<mspace width=\"{}\"/>", symbol.text);
      return symbol.element == "mo" ? math_operator(symbol.text)
                                    : element(symbol.element, symbol.text);
    }
    return construction(name);
  }

  /// A command with arguments.
  std::string construction(std::string_view name) {
    // Without a mathematical font, an accent is drawn at the height of an x, inside a capital. A
    // hat is high enough, but a dot is not, so it is set as a script over the letter.
    const auto over = [&](std::string_view mark, bool is_accent) {
      return fmt::format("<mover accent=\"{}\">{}<mo stretchy=\"false\">{}</mo></mover>", is_accent,
                         argument(), mark);
    };
    rest_.remove_prefix(name.size());
    skip_blanks();
    if (name == "frac") {
      const std::string above = argument();
      return element("mfrac", above + argument());
    }
    if (name == "sqrt") return element("msqrt", argument());
    if (name == "hat") return over("^", true);
    if (name == "dot") return over("˙", false);
    if (name == "text") return element("mtext", with_hard_spaces(braced()));
    if (name == "mathrm") return fmt::format("<mi mathvariant=\"normal\">{}</mi>", braced());
    if (name == "left") return fenced();
    if (name == "begin") return environment();
    fail();
  }

  std::string fenced() {
    const std::string open(1, rest_.front());
    rest_.remove_prefix(1);
    const std::string content = row("\\right");
    expect("\\right");
    if (rest_.empty()) fail();
    const std::string close(1, rest_.front());
    rest_.remove_prefix(1);
    return element("mrow", element("mo", open) + content + element("mo", close));
  }

  std::string environment() {
    const std::string_view name = braced();
    const std::string end = fmt::format("\\end{{{}}}", name);
    std::string rows, cells;
    while (true) {
      cells += element("mtd", row(end));
      if (take("&")) continue;
      rows += element("mtr", std::exchange(cells, {}));
      if (!take("\\\\")) break;
    }
    expect(end);
    const std::string table = fmt::format("<mtable class=\"{}\">{}</mtable>", name, rows);
    if (name == "pmatrix") {
      return element("mrow", element("mo", "(") + table + element("mo", ")"));
    }
    if (name == "cases") return element("mrow", element("mo", "{") + table);
    if (name == "aligned") return table;
    fail();
  }

  std::string_view rest_;
};

}  // namespace

std::string mathml(std::string_view tex) {
  TexReader reader(tex);
  std::string content = reader.row();
  if (!reader.at_end()) throw std::invalid_argument("unbalanced formula: " + std::string(tex));
  return content;
}

}  // namespace twrench::report

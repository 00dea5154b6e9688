#include "report/citations.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace twrench::report {
namespace {

/// The complete references for the short ones of Method::source; others are complete enough.
constexpr std::array<std::pair<std::string_view, std::string_view>, 7> complete_references{{
    {"Simo, Wong,",
     "J. C. Simo, K. K. Wong, Unconditionally stable algorithms for rigid body dynamics that "
     "exactly preserve energy and momentum, Int. J. Numer. Methods Eng. 31 (1991), 19-52"},
    {"McLachlan,",
     "R. I. McLachlan, Explicit Lie-Poisson integration and the Euler equations, Phys. Rev. Lett. "
     "71 (1993), 3043-3046"},
    {"Munthe-Kaas,",
     "H. Munthe-Kaas, High order Runge-Kutta methods on manifolds, Appl. Numer. Math. 29 (1999), "
     "115-127"},
    {"Celledoni, Marthinsen, Owren, Future",
     "E. Celledoni, A. Marthinsen, B. Owren, Commutator-free Lie group methods, Future Gener. "
     "Comput. Syst. 19 (2003), 341-352"},
    {"Suzuki,",
     "M. Suzuki, Fractal decomposition of exponential operators with applications to many-body "
     "theories and Monte Carlo simulations, Phys. Lett. A 146 (1990), 319-323"},
    {"Jorba, Zou,",
     "A. Jorba, M. Zou, A software package for the numerical integration of ODEs by means of "
     "high-order Taylor methods, Exp. Math. 14 (2005), 99-117"},
    {"Jacobi,",
     "C. G. J. Jacobi, Sur la rotation d'un corps, J. reine angew. Math. 39 (1849), 293-350"},
}};

std::string_view complete_reference(std::string_view source) {
  const auto found = std::ranges::find_if(
      complete_references, [&](const auto& entry) { return source.starts_with(entry.first); });
  return found == complete_references.end() ? source : found->second;
}

}  // namespace

std::string Citations::cite(std::string_view reference) {
  const auto found = std::ranges::find(cited_, reference);
  const auto index = found - cited_.begin();
  if (found == cited_.end()) cited_.emplace_back(reference);
  return fmt::format("[{}]", index + 1);
}

std::string Citations::specification() {
  return cite(Phrase("H. J. Rivertz, Rotasjon av stive legemer, project in TDAT3024 (NTNU, 2020)",
                     "H. J. Rivertz, Rotasjon av stive legemer, prosjektoppgave i TDAT3024 (NTNU, "
                     "2020)"));
}

std::string Citations::cite_method(std::string_view source) {
  constexpr std::string_view ours = "specification";
  if (source.starts_with(ours)) {
    std::string place(source.substr(ours.size()));
    constexpr std::string_view equation = "eq.";
    if (const std::size_t at = place.find(equation); at != std::string::npos) {
      place.replace(at, equation.size(), Phrase("eq.", "likning").in(language_));
    }
    return specification() + place;
  }
  return cite(complete_reference(source.substr(0, source.find("; docs/"))));
}

Section Citations::references() const {
  List list;
  for (const std::string& reference : cited_) list.items.push_back(reference + ".");
  return {.heading = Phrase("References", "Referanser").in(language_),
          .content = {std::move(list)}};
}

}  // namespace twrench::report

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/document.h"

namespace twrench::report {

// References other than the sources of methods.
inline constexpr Phrase landau{
    "L. D. Landau, E. M. Lifshitz, Mechanics, 3rd ed. (Pergamon, 1976), section 37",
    "L. D. Landau, E. M. Lifshitz, Mechanics, 3. utg. (Pergamon, 1976), avsnitt 37"};
inline constexpr Phrase feynman{
    "R. P. Feynman, R. B. Leighton, M. Sands, The Feynman Lectures on Physics, vol. I "
    "(Addison-Wesley, 1963), chapter 20",
    "R. P. Feynman, R. B. Leighton, M. Sands, The Feynman Lectures on Physics, bind I "
    "(Addison-Wesley, 1963), kapittel 20"};
inline constexpr std::string_view double_bracket =
    "A. Bloch, P. S. Krishnaprasad, J. E. Marsden, T. S. Ratiu, The Euler-Poincaré equations and "
    "double bracket dissipation, Commun. Math. Phys. 175 (1996), 1-42";
inline constexpr std::string_view ashbaugh =
    "M. S. Ashbaugh, C. C. Chicone, R. H. Cushman, The twisting tennis racket, J. Dyn. Differ. "
    "Equ. 3 (1991), 67-85";
inline constexpr Phrase sauer{"T. Sauer, Numerical Analysis, 2nd ed. (Pearson, 2014), section 6.5",
                              "T. Sauer, Numerical Analysis, 2. utg. (Pearson, 2014), avsnitt 6.5"};
inline constexpr std::string_view lie_integrators =
    "E. Celledoni, H. Marthinsen, B. Owren, An introduction to Lie group integrators - basics, new "
    "developments and applications, J. Comput. Phys. 257 (2014), 1040-1061";
inline constexpr Phrase hairer{
    "E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, 2nd ed. (Springer, 2006)",
    "E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, 2. utg. (Springer, 2006)"};

/// Numbers the references of a report in the order in which they are cited. The list of references
/// contains exactly those that were cited.
class Citations {
 public:
  /// `language` is that of the words beside names and titles.
  explicit Citations(Language language) : language_(language) {}

  /// Returns the number of a reference in brackets, as "[2]", and adds it to the list if it is new.
  std::string cite(std::string_view reference);
  std::string cite(const Phrase& reference) { return cite(reference.in(language_)); }

  /// Cites the specification as cite() does.
  std::string specification();

  /// Returns the citation of a method's source, Method::source; with the equation or section if
  /// this is the specification.
  std::string cite_method(std::string_view source);

  /// Returns the cited references in the order of their numbers.
  Section references() const;

 private:
  Language language_;
  std::vector<std::string> cited_;
};

}  // namespace twrench::report

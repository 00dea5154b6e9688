#include <fmt/format.h>

#include "report/sections.h"
#include "report/tables.h"

namespace twrench::report {
namespace {

void append_adaptive_run(std::vector<std::string>& row, const study::StudyRun& run) {
  const bool done = run.failure.empty() && run.estimate;
  row.push_back(done ? fmt::format("{:.3g}", run.step) : "–");
  row.push_back(done ? brief(run.early_error) : "–");
  row.push_back(done ? brief(run.estimate->median_ratio) : "–");
  row.push_back(done ? brief(run.estimate->largest_error / *run.tolerance) : "–");
}

/// The embedded pair as printed (rkf45), and with the products kept (rkmk45).
Table tolerances_table(const study::Study& study, const Experiment& studied) {
  const Language language = studied.scene.language;
  Table table{
      .caption =
          Phrase(
              "{}: rkf45 as printed and rkmk45. Mean step, error of X at {:.4g} s, true error of "
              "a step over E (median), and its largest over the tolerance",
              "{}: rkf45 som i oppgaveteksten, og rkmk45. Gjennomsnittlig steg, feil i X ved "
              "{:.4g} s, "
              "virkelig feil i et steg delt på E (median), og den største delt på toleransen")
              .in(language, studied.scene.name, study.early),
      .commands = {studied.commands.study_of({"rkf45", "rkmk45"})},
      .header = {Phrase("Tolerance", "Toleranse").in(language)},
      .rows = {}};
  for (const char* method : {"rkf45", "rkmk45"}) {
    table.header.insert(
        table.header.end(),
        {Phrase("{}: step, s", "{}: steg, s").in(language, method),
         Phrase("Error", "Feil").in(language), Phrase("True/E", "Virkelig/E").in(language),
         Phrase("True/tolerance", "Virkelig/toleranse").in(language)});
  }
  const auto &printed = results_of(study, "rkf45").runs, &kept = results_of(study, "rkmk45").runs;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    std::vector<std::string> row{fmt::format("{:.0e}", printed[i].tolerance.value_or(0))};
    append_adaptive_run(row, printed[i]);
    append_adaptive_run(row, kept[i]);
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string estimate_text(const study::Study& study, Language language) {
  const auto exponent = [&](const char* method) {
    const auto& e = results_of(study, method).estimate_exponent;
    return e ? fmt::format("{:.2f}", *e) : std::string("–");
  };
  return Phrase(
             "W′ and Z′ lack the same products, so these cancel in E: the estimate of rkf45 does "
             "not see its own error. The true error of a step over E is proportional to h to the "
             "power {}; with rkmk45 to the power {}. A tolerance therefore says little about the "
             "error of rkf45; with rkmk45 E is close to the true error. Measured orders: rkf45 {}, "
             "rkmk45 {}.",
             "W′ og Z′ mangler de samme produktene, så de faller bort i E: Estimatet til rkf45 ser "
             "ikke sin egen feil. Den virkelige feilen i et steg, delt på E, er proporsjonal med h "
             "opphøyd i {}; med rkmk45 opphøyd i {}. En toleranse sier derfor lite om feilen til "
             "rkf45; med rkmk45 er E nær den virkelige feilen. Målte ordener: rkf45 {}, rkmk45 {}.")
      .in(language, exponent("rkf45"), exponent("rkmk45"), measured_order(study, "rkf45"),
          measured_order(study, "rkmk45"));
}

}  // namespace

Section runge_kutta_section(const study::Study& study, const Experiment& studied,
                            Citations& citations) {
  const Language language = studied.scene.language;
  Section section{
      .heading = Phrase("Task 4: RK4 and RKF45", "Oppgave 4: RK4 og RKF45").in(language),
      .content = {}};
  section.content.emplace_back(Subheading{"RK4"});
  section.content.emplace_back(Paragraph{
      Phrase("The method rk4 is that of section 4.4 of {}, as it is printed there. The T-wrench "
             "tests it, beside lie-euler and rkmk4:",
             "Metoden rk4 er metoden i avsnitt 4.4 i {}, nøyaktig slik den står der. "
             "Den testes på T-nøkkelen, ved siden av lie-euler og rkmk4:")
          .in(language, citations.specification())});
  section.content.emplace_back(ladder_table(study, {"lie-euler", "rk4", "rkmk4"}, studied));
  section.content.emplace_back(Paragraph{
      Phrase("The coefficients of RK4 have order 4 in a linear space, but here rk4 has order {}: "
             "half the step divides the error by 4. This is no slip in the coefficients, which "
             "would bring the order down to 1. One exponential of the averaged velocities leaves "
             "out the products of the theory; with the same coefficients and these products, rkmk4 "
             "has order {}.",
             "Koeffisientene i RK4 har orden 4 i et lineært rom, men her har rk4 "
             "orden {}: Når steget halveres, deles feilen på 4. Det er ingen feil i "
             "koeffisientene, for den ville senket ordenen til 1. Når én "
             "eksponentialfunksjon brukes på gjennomsnittet av vinkelhastighetene, "
             "faller produktene i teorien bort; med de samme koeffisientene og disse "
             "produktene har rkmk4 orden {}.")
          .in(language, measured_order(study, "rk4"), measured_order(study, "rkmk4"))});
  section.content.emplace_back(Subheading{"RKF45"});
  section.content.emplace_back(tolerances_table(study, studied));
  section.content.emplace_back(Paragraph{estimate_text(study, language)});
  return section;
}

}  // namespace twrench::report

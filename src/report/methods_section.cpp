#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "plot/plots.h"
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

constexpr Phrase method_label{"Method", "Metode"};

/// The summaries of the methods in Norwegian, in the order of motion::methods(). Those in English
/// are their own.
constexpr auto norwegian_summaries = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"euler", "Eulers metode på selve matrisen; forlater SO(3); til sammenlikning"},
    {"lie-euler", "Lie-Euler-metoden på gruppen: én eksponentialfunksjon per steg"},
    {"midpoint", "den eksplisitte midtpunktsmetoden på gruppen"},
    {"trapezoid", "den eksplisitte trapesmetoden på gruppen"},
    {"rk4", "RK4 slik den står i oppgaveteksten: ingen kommutatorer, derfor orden 2 på SO(3)"},
    {"rkf45",
     "Runge-Kutta-Fehlberg slik den står i oppgaveteksten, adaptiv: ingen kommutatorer, derfor "
     "orden 2 på "
     "SO(3)"},
    {"implicit-trapezoid", "symmetrisk; bevarer energien, bortsett fra avrunding"},
    {"strang",
     "oppdeling i rotasjoner om hovedaksene; bevarer Poisson-strukturen, begrenset energifeil"},
    {"rkmk4", "RK4 fra oppgaveteksten med korreksjon for kommutatorer"},
    {"rkmk45",
     "RKF45 fra oppgaveteksten med korreksjon for kommutatorer, adaptiv; brukes om ingen annen er "
     "valgt"},
    {"cf4", "uten kommutatorer: produkter av to eksponentialfunksjoner"},
    {"suzuki4", "fem implisitte trapessteg per steg; bevarer energien, bortsett fra avrunding"},
    {"taylor",
     "Taylor-rekke for dreieimpulsen og én vinkel, adaptiv; bevarer energien; den raskeste"},
    {"exact",
     "lukket form med elliptiske funksjoner og thetafunksjoner; like rask for alle tidspunkter t"},
});

std::string summary_in(Language language, const motion::Method& method) {
  const auto found = std::ranges::find(norwegian_summaries, method.name,
                                       [](const auto& entry) { return entry.first; });
  const bool is_translated = language == Language::nb && found != norwegian_summaries.end();
  return std::string(is_translated ? found->second : method.summary);
}

Table sources_table(const study::Study& study, Language language, Citations& citations) {
  Table table{
      .caption = Phrase("The methods, their sources, and their orders on SO(3)",
                        "Metodene, kildene deres og ordenene deres på SO(3)")
                     .in(language),
      .commands = {"twrench methods"},
      .header = {method_label.in(language), Phrase("What it is", "Beskrivelse").in(language),
                 Phrase("Source", "Kilde").in(language), Phrase("Order", "Orden").in(language),
                 Phrase("Measured", "Målt").in(language)},
      .rows = {},
      .text_columns = 3};
  for (const study::MethodStudy& m : study.methods) {
    const motion::Method& method = *m.method;
    table.rows.push_back(
        {std::string(method.name), summary_in(language, method),
         citations.cite_method(method.source),
         method.order ? fmt::to_string(*method.order) : Phrase("exact", "eksakt").in(language),
         measured_order(study, method.name)});
  }
  return table;
}

std::vector<std::string> row_of_method(const study::MethodStudy& m, const study::Study& study) {
  const std::string name(m.method->name);
  const study::StudyRun* run = middle_run(m);
  if (run == nullptr) return {name, "–", "–", "–", "–", "–", "–", "–", "–"};
  const bool exact = m.method->exact();
  return {name,
          exact ? "–" : fmt::format("{:.4g}", run->step),
          exact ? "–" : brief(run->error),
          brief(run->energy_drift),
          exact ? "–" : brief(run->error / run->energy_drift),
          brief(run->orthogonality_error),
          fmt::format("{}/{}", run->flips.size(), study.flip_times.size()),
          fmt::to_string(run->evaluations),
          fmt::format("{:.3f}", 1e3 * run->cpu_seconds)};
}

Table results_table(const study::Study& study, const Experiment& studied) {
  const Language language = studied.scene.language;
  Table table{
      .caption =
          Phrase(
              "{}: each method at the middle of its ladder of steps or tolerances. Error of X at "
              "{} s, largest energy drift, error over drift, flips seen/predicted, and "
              "evaluations of ω",
              "{}: hver metode med det midterste av stegene eller toleransene. Feil i X ved {} s, "
              "største energidrift, feil delt på drift, vendinger funnet/forutsagt, og antall "
              "beregninger av ω")
              .in(language, studied.scene.name, digits(study.duration)),
      .commands = {studied.commands.study},
      .header = {method_label.in(language), step_label.in(language),
                 Phrase("Error of X", "Feil i X").in(language), "Drift",
                 Phrase("Error/drift", "Feil/drift").in(language), "‖XᵀX − Id‖",
                 Phrase("Flips", "Vendinger").in(language),
                 Phrase("Evaluations", "Beregninger").in(language), "CPU, ms"},
      .rows = {}};
  for (const study::MethodStudy& m : study.methods) table.rows.push_back(row_of_method(m, study));
  return table;
}

/// The methods of the study with a fixed step.
std::vector<std::string> fixed_step_methods(const study::Study& study) {
  std::vector<std::string> names;
  for (const study::MethodStudy& m : study.methods) {
    if (!m.method->exact() && !m.method->adaptive()) names.emplace_back(m.method->name);
  }
  return names;
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

Section methods_section(const study::Study& study, const Experiment& studied,
                        Citations& citations) {
  const Language language = studied.scene.language;
  Section section{.heading = Phrase("All methods", "Alle metodene").in(language), .content = {}};
  section.content.emplace_back(sources_table(study, language, citations));
  section.content.emplace_back(results_table(study, studied));
  section.content.emplace_back(Figure{
      .name = "methods",
      .caption =
          Phrase("{}: order (error of X at {:.4g} s), work and precision (error of X at {} s), "
                 "error of X against energy drift, and energy drift against time",
                 "{}: orden (feil i X ved {:.4g} s), arbeid og nøyaktighet (feil i X ved {} s), "
                 "feil i X mot energidrift, og energidrift mot tiden")
              .in(language, studied.scene.name, study.early, digits(study.duration)),
      .command = studied.commands.diagrams,
      .plot = plot::study_plot(study, language)});
  section.content.emplace_back(ladder_table(study, fixed_step_methods(study), studied));
  return section;
}

}  // namespace twrench::report

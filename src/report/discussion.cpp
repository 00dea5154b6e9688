#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "report/sections.h"
#include "report/tables.h"

namespace twrench::report {
namespace {

Paragraph orders_paragraph(const study::Study& study, Language language) {
  std::vector<std::string> orders;
  for (const study::MethodStudy& m : study.methods) {
    if (m.order) orders.push_back(fmt::format("{} {:.2f}", m.method->name, *m.order));
  }
  if (orders.empty()) {
    return {
        Phrase("No order can be measured on this motion: the errors are rounding errors or not "
               "small enough.",
               "Ingen orden kan måles på denne bevegelsen: Feilene er avrundingsfeil eller ikke "
               "små nok.")
            .in(language)};
  }
  return {
      Phrase(
          "The measured orders are {}. The theory predicts 1 for the Euler methods; 2 for "
          "midpoint, "
          "trapezoid, implicit-trapezoid and strang, and also for rk4 and rkf45 as printed; and 4 "
          "for the others with steps. The order of a tableau is that in a linear space: on SO(3) "
          "it "
          "needs the products that averaging leaves out. The Taylor series has no measured order, "
          "because nothing lies between steps that are too long for it and rounding.",
          "De målte ordenene er {}. Etter teorien skal Euler-metodene ha orden 1, "
          "midpoint, trapezoid, implicit-trapezoid og strang orden 2, og det samme "
          "gjelder rk4 og rkf45 slik de står i oppgaveteksten. De andre metodene "
          "med steg skal ha orden 4. Ordenen til et Butcher-tablå gjelder i et "
          "lineært rom: På SO(3) trengs i tillegg produktene som faller bort når "
          "vinkelhastigheter midles. Taylor-rekken har ingen målt orden, for det "
          "er ingenting mellom steg som er for lange for den, og avrundingsfeil.")
          .in(language, fmt::format("{}", fmt::join(orders, ", ")))};
}

/// The error and the energy drift of a method in the middle of its ladder; empty if it failed.
std::string error_and_drift(const study::Study& study, std::string_view method, Language language) {
  const study::StudyRun* run = middle_run(results_of(study, method));
  if (run == nullptr) return {};
  return Phrase("{} has an error of X of {} with an energy drift of {} (step {:.4g} s)",
                "{} har en feil i X på {} med en energidrift på {} (steg {:.4g} s)")
      .in(language, method, brief(run->error), brief(run->energy_drift), run->step);
}

Paragraph energy_paragraph(const study::Study& study, Language language, Citations& citations) {
  constexpr double round_off = 1e-12;
  const study::StudyRun* plain = middle_run(results_of(study, "lie-euler"));
  if (plain != nullptr && plain->energy_drift < round_off) {
    return {
        Phrase("The energy says nothing about the methods here: even Lie-Euler, which does not "
               "conserve it in general, keeps it to {}.",
               "Energien sier ingenting om metodene her: Selv Lie-Euler, som ellers ikke bevarer "
               "den, holder den innenfor {}.")
            .in(language, brief(plain->energy_drift))};
  }
  std::vector<std::string> found;
  for (const char* method : {"rk4", "strang", "implicit-trapezoid"}) {
    std::string text = error_and_drift(study, method, language);
    if (!text.empty()) found.push_back(std::move(text));
  }
  return {
      Phrase(
          "The error against the energy: a motion with a large energy drift is wrong, but one "
          "without is not yet right. {}. The drift decreases with the step as the error does, but "
          "the ratio of the two differs from method to method: methods that conserve the energy by "
          "construction, or nearly, move along the right curve at a wrong speed {}. The drift is "
          "therefore a check of one method with another step, and not a comparison of methods.",
          "Feilen mot energien: En bevegelse med stor energidrift er feil, men en "
          "uten er ikke dermed riktig. {}. Driften avtar med steget slik feilen "
          "gjør, men forholdet mellom de to er forskjellig fra metode til metode: "
          "Metoder som bevarer energien, helt eller nesten, følger den riktige "
          "kurven med feil fart {}. Driften kan derfor brukes til å kontrollere én "
          "metode med et annet steg, men ikke til å sammenlikne metoder.")
          .in(language, fmt::format("{}", fmt::join(found, "; ")), citations.cite(hairer))};
}

Paragraph construction_paragraph(const study::Study& study, Language language) {
  const study::StudyRun *linear = middle_run(results_of(study, "euler")),
                        *lie = middle_run(results_of(study, "lie-euler"));
  const std::string distances =
      linear == nullptr || lie == nullptr
          ? std::string()
          : Phrase(
                " Lie-Euler keeps XᵀX = Id to {} although its error of X is {}; Euler's method "
                "is {} away from it.",
                " Lie-Euler oppfyller XᵀX = Id på {} nær, enda feilen i X er {}; Eulers metode "
                "er {} unna.")
                .in(language, brief(lie->orthogonality_error), brief(lie->error),
                    brief(linear->orthogonality_error));
  return {
      Phrase("A method on the group keeps XᵀX = Id and the momentum L by construction, up to "
             "rounding. That is no evidence of accuracy.",
             "En metode på gruppen bevarer XᵀX = Id og dreieimpulsen L, bortsett fra avrunding, "
             "fordi den er bygd slik. Det er ikke noe bevis for at den er nøyaktig.")
          .in(language) +
      distances};
}

/// The effect of a wrong energy on the flips: rk4 with its longest step.
Paragraph flips_paragraph(const PrintedSolution& solution) {
  const Language language = solution.solution.scene().language;
  const study::Study& rk4 = solution.rk4;
  const study::StudyRun& coarse = rk4.methods.front().runs.front();
  const study::StudyRun& quiet = solution.run();
  if (rk4.flip_times.empty() || !coarse.failure.empty() || !std::isfinite(coarse.flip_error)) {
    return {Phrase("Within this time the T-wrench does not turn over.",
                   "I løpet av denne tiden snur ikke T-nøkkelen.")
                .in(language)};
  }
  return {
      Phrase(
          "The flips are sensitive to the energy: a wrong energy belongs to another motion, with "
          "another time between flips, and the error of each adds to that of the next. With a step "
          "of {} s rk4 has {} flips of {}, and their times are wrong by up to {} s; with {} s, by "
          "{} s. Nothing in a film would look wrong.",
          "Vendingene er følsomme for energien: Feil energi hører til en annen "
          "bevegelse, med en annen tid mellom vendingene, og feilen i hver av dem "
          "legges til feilen i den neste. Med et steg på {} s har rk4 {} av {} "
          "vendinger, og tidspunktene er opptil {} s feil; med {} s opptil {} s. I "
          "en film ville ingenting sett galt ut.")
          .in(language, coarse.step, coarse.flips.size(), rk4.flip_times.size(),
              brief(coarse.flip_error), quiet.step, brief(quiet.flip_error))};
}

Paragraph stability_paragraph(std::span<const PrintedSolution> solutions, Language language,
                              Citations& citations) {
  std::vector<std::string> swings;
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    if (const auto flips = solutions[i].solution.flips()) {
      swings.push_back(fmt::format("({}) {:.1f}", "abc"[i], flips -> swing * 180 / std::acos(-1)));
    }
  }
  return {
      Phrase(
          "The motions agree with the theorem of the intermediate axis {}: a rotation about the "
          "axes of least and greatest moment is stable, about the intermediate one it is not. The "
          "intermediate axis swings by {} degrees. The momentum L is constant in space and its "
          "curve in the body is the intersection of a sphere with an ellipsoid: small closed "
          "curves "
          "about the stable axes, and long ones past both ends of the intermediate axis {}. That "
          "is "
          "what the graphs show: waiting near one end, then a quick passage to the other.",
          "Bevegelsene stemmer med teoremet om den midterste aksen {}: En rotasjon om aksen med "
          "minst eller størst treghetsmoment er stabil, om den midterste er den ustabil. Den "
          "midterste aksen svinger {} grader. Dreieimpulsen L er konstant i rommet, og i legemet "
          "følger den skjæringskurven mellom en kule og en ellipsoide: små lukkede kurver om de "
          "stabile aksene og lange kurver forbi begge endene av den midterste aksen {}. Det er "
          "dette grafene viser: venting nær den ene enden, så en rask overgang til den andre.")
          .in(language, citations.cite(ashbaugh), fmt::format("{}", fmt::join(swings, ", ")),
              citations.cite(landau))};
}

Paragraph outlook_paragraph(Language language) {
  return {
      Phrase("Three questions could be examined further. With a torque, or in a body that loses "
             "energy, the methods have no closed form to be compared with. The step control of "
             "rkf45 needs an estimate that sees the whole error. Over very long times, methods "
             "that conserve the energy should win although their errors at a given step are "
             "larger.",
             "Tre spørsmål kunne vært undersøkt videre. Med et kraftmoment, eller i et legeme som "
             "taper energi, finnes det ingen lukket form å sammenlikne metodene med. "
             "Stegkontrollen i rkf45 trenger et estimat som ser hele feilen. Over svært lange "
             "tider burde metoder som bevarer energien, vinne, selv om feilene deres er større "
             "ved et gitt steg.")
          .in(language)};
}

std::string discussion_heading(Language language) {
  return Phrase("Discussion", "Diskusjon").in(language);
}

}  // namespace

Section discussion_of_tasks(std::span<const PrintedSolution> solutions, const study::Study& study,
                            Citations& citations) {
  const Language language = solutions.front().solution.scene().language;
  return {
      .heading = discussion_heading(language),
      .content = {stability_paragraph(solutions, language, citations),
                  orders_paragraph(study, language), energy_paragraph(study, language, citations),
                  construction_paragraph(study, language), flips_paragraph(solutions.front()),
                  outlook_paragraph(language)}};
}

Section discussion_of_motions(const study::Study& study, Language language, Citations& citations) {
  return {
      .heading = discussion_heading(language),
      .content = {orders_paragraph(study, language), energy_paragraph(study, language, citations),
                  construction_paragraph(study, language)}};
}

}  // namespace twrench::report

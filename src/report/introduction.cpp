#include <twrench/motion/method.h>

#include "report/sections.h"

namespace twrench::report {
namespace {

/// States the source of the numbers; part of every introduction.
Paragraph about_numbers(Language language, Citations& citations) {
  return {Phrase("The motion is also known in closed form {}, which gives the error of every "
                 "method. All numbers were computed when this report was written; below each table "
                 "and figure stand the commands that give the same.",
                 "Bevegelsen er også kjent på lukket form {}, og det gir feilen til hver metode. "
                 "Alle tallene ble regnet ut da rapporten ble skrevet. Under hver tabell og figur "
                 "står kommandoene som gir de samme tallene.")
              .in(language, citations.cite_method(motion::find_method("exact").source))};
}

}  // namespace

Section introduction_to_tasks(Language language, Citations& citations) {
  const std::string effect = citations.cite(ashbaugh);
  Section section{.heading = Phrase("Introduction", "Innledning").in(language), .content = {}};
  section.content.emplace_back(Paragraph{
      Phrase(
          "A rigid body on which no external torque acts turns about its centre of mass, and its "
          "motion can be surprising: a T-shaped wrench that spins about its intermediate axis "
          "turns over again and again, although nothing pushes it {}. This report solves the tasks "
          "of {}: it computes how such a body turns, by methods that keep its attitude a rotation, "
          "tests the methods, and explains what the solutions show.",
          "Et stivt legeme som ikke er utsatt for ytre kraftmomenter, roterer om massesenteret "
          "sitt, og bevegelsen kan være overraskende: En T-nøkkel som spinner om den midterste "
          "aksen, snur om og om igjen, enda ingenting dytter på den {}. Denne rapporten løser "
          "oppgavene i {}: Den regner ut hvordan et slikt legeme roterer, med metoder der "
          "stillingen forblir en rotasjon, tester metodene og forklarer hva løsningene viser.")
          .in(language, effect, citations.specification())});
  section.content.emplace_back(Paragraph{
      Phrase(
          "Task 1 provides the functions: the exponential, the energy, and the inertia of the "
          "T-wrench. Task 2 solves the motion of a sphere exactly, and task 3 tests the "
          "Lie-Euler method with it. Task 4 is about the Runge-Kutta methods RK4 and RKF45. "
          "Task 5 computes the motion of the T-wrench from three initial angular velocities, "
          "and task 6 draws the nine components of its attitude and interprets them. Then all "
          "methods are compared, and the results discussed.",
          "Oppgave 1 lager funksjonene som trengs: eksponentialfunksjonen, energien og "
          "treghetsmomentet til T-nøkkelen. Oppgave 2 løser bevegelsen til en kule eksakt, og "
          "oppgave 3 bruker løsningen til å teste Lie-Euler-metoden. Oppgave 4 handler om "
          "Runge-Kutta-metodene RK4 og RKF45. Oppgave 5 regner ut bevegelsen til T-nøkkelen for "
          "tre vinkelhastigheter ved start, og oppgave 6 tegner de ni komponentene av stillingen "
          "og tolker dem. Til slutt sammenliknes alle metodene, og resultatene diskuteres.")
          .in(language)});
  section.content.emplace_back(about_numbers(language, citations));
  return section;
}

Section introduction_to_motions(Language language, Citations& citations, bool has_interior) {
  Section section{.heading = Phrase("Introduction", "Innledning").in(language), .content = {}};
  section.content.emplace_back(Paragraph{
      Phrase(
          "This report is about the rotation of a rigid body about its centre of mass when no "
          "external torque acts on it. It contains the equations of {}, the body, its motion, and "
          "a comparison of methods that compute the motion.",
          "Denne rapporten handler om hvordan et stivt legeme roterer om massesenteret sitt når "
          "ingen ytre kraftmomenter virker på det. Den inneholder likningene fra {}, legemet, "
          "bevegelsen og en sammenlikning av metoder som regner den ut.")
          .in(language, citations.specification())});
  section.content.emplace_back(about_numbers(language, citations));
  if (has_interior) {
    section.content.emplace_back(Paragraph{
        Phrase("If a body contains a wheel or loses energy, its motion has no closed form. There "
               "the errors are differences from the method taylor with the tolerance {}.",
               "Hvis legemet inneholder et svinghjul eller taper energi, har bevegelsen ingen "
               "lukket form. Da er feilene avvik fra metoden taylor med toleransen {}.")
            .in(language, motion::min_tolerance)});
  }
  return section;
}

}  // namespace twrench::report

#include <twrench/math/so3.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/method.h>

#include <cmath>
#include <vector>

#include "report/sections.h"
#include "report/tables.h"

namespace twrench::report {
namespace {

/// The body of task 2.
motion::FreeBody unit_sphere() { return {Eigen::Matrix3d::Identity(), Eigen::Vector3d::UnitX()}; }

/// The solution of task 2, written out.
Eigen::Matrix3d sphere_attitude(double t) {
  Eigen::Matrix3d X = Eigen::Matrix3d::Identity();
  X(1, 1) = X(2, 2) = std::cos(t);
  X(2, 1) = std::sin(t);
  X(1, 2) = -X(2, 1);
  return X;
}

Table sphere_table(const TaskCommands& commands, Language language) {
  const std::vector<double> times{1, 10, 100};
  const motion::ExactMotion exact(unit_sphere());
  Table table{.caption = Phrase("The solution at three times, and the library's closed form",
                                "Løsningen ved tre tidspunkter, og programmets lukkede form")
                             .in(language),
              .commands = {commands.sphere(times)},
              .header = {"t, s", "cos t", "x₂₂", "sin t", "x₃₂",
                         Phrase("Difference of X", "Avvik i X").in(language)},
              .rows = {}};
  for (const double t : times) {
    const Eigen::Matrix3d X = exact.at(t).X, ours = sphere_attitude(t);
    table.rows.push_back({digits(t), digits(ours(1, 1)), digits(X(1, 1)), digits(ours(2, 1)),
                          digits(X(2, 1)), brief((X - ours).norm())});
  }
  return table;
}

/// Lie-Euler and Euler on the sphere.
Table sphere_errors_table(const TaskCommands& commands, Language language) {
  study::StudyPlan plan;
  plan.methods = {&motion::find_method("lie-euler"), &motion::find_method("euler")};
  plan.steps = {0.1, 0.01, 0.001};
  plan.duration = 100;
  const study::Study study = study::run_study(unit_sphere(), plan);
  Table table{
      .caption = Phrase("The sphere: errors after 100 s against the solution of task 2",
                        "Kulen: feil etter 100 s mot løsningen i oppgave 2")
                     .in(language),
      .commands = {commands.sphere_study({"lie-euler", "euler"}, plan.steps, plan.duration)},
      .header = {step_label.in(language),
                 Phrase("Lie-Euler: error of X", "Lie-Euler: feil i X").in(language), "‖XᵀX − Id‖",
                 Phrase("Euler: error of X", "Euler: feil i X").in(language), "‖XᵀX − Id‖"},
      .rows = {}};
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const study::StudyRun &lie = study.methods[0].runs[i], &linear = study.methods[1].runs[i];
    table.rows.push_back({digits(plan.steps[i]), brief(lie.error), brief(lie.orthogonality_error),
                          brief(linear.error), brief(linear.orthogonality_error)});
  }
  return table;
}

}  // namespace

Section sphere_section(const TaskCommands& commands, Language language, Citations& citations) {
  Section section{
      .heading = Phrase("Task 2: the sphere, exactly", "Oppgave 2: kulen, eksakt").in(language),
      .content = {}};
  section.content.emplace_back(Paragraph{
      Phrase("For a sphere with I = Id, X(0) = Id and L = (1, 0, 0), eq. (19) of {} is ω = XᵀL. So "
             "Ω is the hat of XᵀL, and eq. (20) becomes",
             "For en kule med I = Id, X(0) = Id og L = (1, 0, 0) sier likning (19) i "
             "{} at ω = XᵀL. Altså er Ω hattmatrisen til XᵀL, og likning (20) blir")
          .in(language, citations.specification())});
  section.content.emplace_back(formula(
      "sphere",
      Phrase(
          "because the hat of Rv, for a rotation R, is R v̂ Rᵀ: for every a, Rv × a = R(v × Rᵀa). "
          "Here R = Xᵀ. X is a rotation at all times, because d(XXᵀ)/dt = XΩXᵀ + XΩᵀXᵀ = 0, as "
          "Ωᵀ = −Ω.",
          "fordi hattmatrisen til Rv, for en rotasjon R, er R v̂ Rᵀ: For alle a er Rv × a = R(v × "
          "Rᵀa). Her er R = Xᵀ. X er en rotasjon til alle tider, fordi d(XXᵀ)/dt = XΩXᵀ + XΩᵀXᵀ "
          "= 0, siden Ωᵀ = −Ω.")
          .in(language)));
  section.content.emplace_back(Paragraph{
      Phrase(
          "This is a linear equation with constant coefficients. Its right-hand side is Lipschitz "
          "continuous with the constant ‖L̂‖, so by the theorem of Picard and Lindelöf it has "
          "exactly "
          "one solution with X(0) = Id, for all t. The exponential series, differentiated term by "
          "term, shows that exp(tL̂) is one:",
          "Dette er en lineær likning med konstante koeffisienter. Høyresiden er "
          "Lipschitz-kontinuerlig med konstanten ‖L̂‖, så ifølge Picard-Lindelöfs teorem har den "
          "nøyaktig én løsning med X(0) = Id, for alle t. Når eksponentialrekken deriveres ledd "
          "for "
          "ledd, viser den at exp(tL̂) er en løsning:")
          .in(language)});
  section.content.emplace_back(
      formula("sphere_attitude",
              Phrase("The matrix follows from eq. (21) of {} with Ω = L̂, w = 1. As L̂L = 0, "
                     "ω = XᵀL = (1, 0, 0) is constant: the sphere turns about x at 1 rad/s.",
                     "Matrisen følger av likning (21) i {} med Ω = L̂, w = 1. Siden L̂L = 0, er "
                     "ω = XᵀL = (1, 0, 0) konstant: Kulen roterer om x med 1 rad/s.")
                  .in(language, citations.specification())));
  section.content.emplace_back(sphere_table(commands, language));
  return section;
}

Section lie_euler_section(const study::Study& study, const Experiment& studied,
                          const TaskCommands& commands) {
  const Language language = studied.scene.language;
  Section section{
      .heading =
          Phrase("Task 3: the Lie-Euler method", "Oppgave 3: Lie-Euler-metoden").in(language),
      .content = {}};
  section.content.emplace_back(Paragraph{
      Phrase("The first test is the sphere of task 2, whose solution is known. Euler's method is "
             "shown for comparison.",
             "Den første testen er kulen fra oppgave 2, der løsningen er kjent. Eulers metode er "
             "tatt med til sammenlikning.")
          .in(language)});
  section.content.emplace_back(sphere_errors_table(commands, language));
  section.content.emplace_back(Paragraph{
      Phrase("The errors of Lie-Euler are rounding errors: they grow with the number of steps and "
             "not with their length. For the sphere ω is constant, so each step is exact, whatever "
             "its length. The sphere therefore shows that the exponential is right, but cannot "
             "reveal the order of the method, nor a wrong ω: that takes a body whose ω changes. "
             "Euler's method leaves SO(3), and is of first order.",
             "Feilene til Lie-Euler er avrundingsfeil: De vokser med antall steg, "
             "ikke med steglengden. For kulen er ω konstant, så hvert steg er eksakt, "
             "uansett lengde. Kulen viser derfor at eksponentialfunksjonen er riktig, "
             "men den kan ikke avsløre ordenen til metoden, og heller ikke en feil i "
             "ω: Da trengs et legeme der ω endrer seg. Eulers metode forlater SO(3) "
             "og er av første orden.")
          .in(language)});
  section.content.emplace_back(ladder_table(study, {"euler", "lie-euler"}, studied));
  section.content.emplace_back(Paragraph{
      Phrase(
          "On the T-wrench half the step halves the error of Lie-Euler: it is of first order, as "
          "its Taylor series says; measured, {}.",
          "På T-nøkkelen halveres feilen til Lie-Euler når steget halveres: "
          "Metoden er av første orden, som Taylor-rekken sier. Den målte ordenen "
          "er {}.")
          .in(language, measured_order(study, "lie-euler"))});
  return section;
}

}  // namespace twrench::report

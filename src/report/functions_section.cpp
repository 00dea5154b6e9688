#include <fmt/format.h>
#include <twrench/body/shape.h>
#include <twrench/math/so3.h>
#include <twrench/motion/diagnostics.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "report/sections.h"
#include "report/tables.h"

namespace twrench::report {
namespace {

/// The test of task 1 (a), and its largest error.
std::pair<Table, double> test_exponential(const TaskCommands& commands, Language language) {
  const Eigen::Matrix3d Omega = so3::hat({0.36, 0.48, 0.8});
  const std::vector<double> lengths{1e-8, 1e-4, 0.1, 1.0, 2.0, 3.14159, 6.0};
  Table table{
      .caption = Phrase("exp(hΩ) for ω = (0.36, 0.48, 0.8) rad/s, where |ω| = 1 rad/s: is it a "
                        "rotation, and is it twice half of it?",
                        "exp(hΩ) for ω = (0.36, 0.48, 0.8) rad/s, der |ω| = 1 rad/s: Er den en "
                        "rotasjon, og er den lik to halve etter hverandre?")
                     .in(language),
      .commands = {commands.exponentials("0.36,0.48,0.8", lengths.back(), lengths)},
      .header = {"h, s", "‖XᵀX − Id‖", "|det X − 1|", "‖X − exp(hΩ/2)²‖"},
      .rows = {}};
  double largest = 0;
  for (const double h : lengths) {
    const Eigen::Matrix3d X = so3::exp(h, Omega), half = so3::exp(h / 2, Omega);
    const Eigen::Vector3d errors((X.transpose() * X - Eigen::Matrix3d::Identity()).norm(),
                                 std::abs(X.determinant() - 1), (X - half * half).norm());
    table.rows.push_back(
        {fmt::format("{}", h), brief(errors[0]), brief(errors[1]), brief(errors[2])});
    largest = std::max(largest, errors.maxCoeff());
  }
  return {std::move(table), largest};
}

Table energy_table(std::span<const PrintedSolution> solutions) {
  const Language language = solutions.front().solution.scene().language;
  Table table{.caption = Phrase("The energy at t = 0 and its parts",
                                "Energien ved t = 0 og delene den består av")
                             .in(language),
              .commands = {},
              .header = {Phrase("Experiment", "Eksperiment").in(language), "½ Ixx ωx²", "½ Iyy ωy²",
                         "½ Izz ωz²", "T, g cm²/s²"},
              .rows = {}};
  for (const PrintedSolution& printed : solutions) {
    const Solution& solution = printed.solution;
    const Eigen::Vector3d omega = solution.body.omega();
    const Eigen::Matrix3d& inertia = solution.body.inertia();
    const Eigen::Vector3d parts = 0.5 * inertia.diagonal().cwiseProduct(omega.cwiseAbs2());
    table.rows.push_back({solution.scene().name, digits(parts[0]), digits(parts[1]),
                          digits(parts[2]), digits(motion::energy(inertia, omega))});
    table.commands.push_back(solution.experiment->commands.start);
  }
  return table;
}

/// A cylinder of the T-wrench.
struct WrenchPart {
  double length, radius, density, centre;

  double mass() const { return std::numbers::pi * radius * radius * length * density; }
};

WrenchPart wrench_part(const body::Part& part) {
  const auto& cylinder = std::get<body::Cylinder>(part.shape);
  return {cylinder.length, cylinder.radius, part.density, part.position.x()};
}

Table parts_table(const WrenchPart& handle, const WrenchPart& leg, const Experiment& experiment) {
  const body::MassProperties body = scene::mass_properties(experiment.scene.body);
  const Language language = experiment.scene.language;
  const auto row = [&](const Phrase& name, const WrenchPart& part) {
    return std::vector<std::string>{name.in(language), digits(part.length), digits(part.radius),
                                    digits(part.centre), digits(part.mass())};
  };
  return {
      .caption = Phrase("The T-wrench: two cylinders of the density ρ = {} g/cm³. The axis of the "
                        "handle is parallel to y, that of the leg is x",
                        "T-nøkkelen: to sylindre med massetettheten ρ = {} g/cm³. Aksen til "
                        "håndtaket er parallell med y, aksen til beinet er x")
                     .in(language, digits(handle.density)),
      .commands = {experiment.commands.inertia},
      .header = {Phrase("Part", "Del").in(language),
                 Phrase("Length, cm", "Lengde, cm").in(language), "Radius, cm",
                 Phrase("Centre, x in cm", "Sentrum, x i cm").in(language),
                 Phrase("Mass, g", "Masse, g").in(language)},
      .rows = {row({"1: handle", "1: håndtak"}, handle),
               row({"2: leg", "2: bein"}, leg),
               {Phrase("Both", "Begge").in(language), "", "", digits(body.centre_of_mass.x()),
                digits(body.mass)}}};
}

/// Eq. (46)-(48), evaluated as printed.
Eigen::Vector3d printed_inertia(const WrenchPart& handle, const WrenchPart& leg) {
  const double M1 = handle.mass(), L1 = handle.length, R1 = handle.radius;
  const double M2 = leg.mass(), L2 = leg.length, R2 = leg.radius;
  return {M1 * R1 * R1 / 4 + M1 * L1 * L1 / 12 + M2 * R2 * R2 / 2,
          M1 * R1 * R1 + M2 * L2 * L2 / 4 + M1 * R1 * R1 / 2 + M2 * R2 * R2 / 4 + M2 * L2 * L2 / 12,
          M1 * R1 * R1 + M2 * L2 * L2 / 4 + M1 * R1 * R1 / 4 + M1 * L1 * L1 / 12 +
              M2 * R2 * R2 / 4 + M2 * L2 * L2 / 12};
}

Table printed_inertia_table(const WrenchPart& handle, const WrenchPart& leg,
                            const Solution& solution) {
  const Eigen::Vector3d printed = printed_inertia(handle, leg);
  const Language language = solution.scene().language;
  Table table{
      .caption = Phrase("The moments of inertia of the T-wrench, g cm²: by these formulas, "
                        "and by the general ones for parts of any shape and place",
                        "Treghetsmomentene til T-nøkkelen, g cm²: etter disse formlene og etter "
                        "de generelle for deler med vilkårlig form og plassering")
                     .in(language),
      .commands = {solution.experiment->commands.inertia},
      .header = {"Moment", Phrase("Eq. (46)-(48)", "Likning (46)-(48)").in(language),
                 Phrase("From the parts", "Fra delene").in(language),
                 Phrase("Relative difference", "Relativt avvik").in(language)},
      .rows = {}};
  for (int i = 0; i < 3; ++i) {
    const double general = solution.body.inertia()(i, i);
    const char axis = "xyz"[i];
    table.rows.push_back({fmt::format("I{0}{0}", axis), fmt::format("{:.6f}", printed[i]),
                          fmt::format("{:.6f}", general), brief(printed[i] / general - 1)});
  }
  return table;
}

void add_inertia(Section& section, const Solution& solution, Citations& citations) {
  const std::vector<body::Part>& parts = solution.scene().body.parts;
  const WrenchPart handle = wrench_part(parts.at(0)), leg = wrench_part(parts.at(1));
  const Language language = solution.scene().language;
  section.content.emplace_back(
      Subheading{Phrase("(c) The inertia of the T-wrench", "(c) Treghetsmomentet til T-nøkkelen")
                     .in(language)});
  section.content.emplace_back(parts_table(handle, leg, *solution.experiment));
  section.content.emplace_back(formula(
      "wrench_inertia",
      Phrase(
          "Eq. (46)-(48) of {}: M, L and R are the masses, lengths and radii of the parts 1 and 2, "
          "M = πR²Lρ. The first two terms of Iyy and Izz move the axes of the parts to the common "
          "centre of mass, the origin. The products of inertia are zero.",
          "Likning (46)-(48) i {}: M, L og R er massene, lengdene og radiene til delene 1 og 2, "
          "M = πR²Lρ. De to første leddene i Iyy og Izz flytter aksene til delene til det felles "
          "massesenteret, origo. Treghetsproduktene er null.")
          .in(language, citations.specification())));
  section.content.emplace_back(printed_inertia_table(handle, leg, solution));
  section.content.emplace_back(axes_table(*solution.experiment));
  section.content.emplace_back(Paragraph{
      Phrase("Iyy < Ixx < Izz: x is the intermediate axis. A small tilt of a rotation about it "
             "grows exponentially; about y or z it wobbles.",
             "Iyy < Ixx < Izz: x er den midterste aksen. En liten helling vokser "
             "eksponentielt når legemet roterer om den; om y eller z slingrer det "
             "bare.")
          .in(language)});
}

}  // namespace

Section functions_section(std::span<const PrintedSolution> solutions, const TaskCommands& commands,
                          Citations& citations) {
  const Language language = solutions.front().solution.scene().language;
  Section section{.heading = Phrase("Task 1: the functions", "Oppgave 1: funksjonene").in(language),
                  .content = {}};
  section.content.emplace_back(
      Subheading{Phrase("(a) The exponential", "(a) Eksponentialfunksjonen").in(language)});
  section.content.emplace_back(Paragraph{
      Phrase("The function so3::exp(h, Omega) evaluates eq. (21) of {}. For a small angle wh, the "
             "difference 1 − cos wh loses all digits; its equal 2 sin²(wh/2) loses none. The test:",
             "Funksjonen so3::exp(h, Omega) regner ut likning (21) i {}. For en liten vinkel wh "
             "mister differansen 1 − cos wh alle sifrene; 2 sin²(wh/2), som er det samme, mister "
             "ingen. Testen:")
          .in(language, citations.specification())});
  auto [table, largest] = test_exponential(commands, language);
  section.content.emplace_back(std::move(table));
  section.content.emplace_back(Paragraph{
      Phrase(
          "The largest error is {}, and the rounding of one number near 1 is 1.1e-16: exp(hΩ) is "
          "a rotation, XᵀX = Id, for angles from almost zero to almost a full turn.",
          "Den største feilen er {}, og avrundingen av ett tall nær 1 er 1.1e-16: exp(hΩ) er en "
          "rotasjon, XᵀX = Id, for vinkler fra nesten null til nesten en hel omdreining.")
          .in(language, brief(largest))});
  section.content.emplace_back(Subheading{Phrase("(b) The energy", "(b) Energien").in(language)});
  section.content.emplace_back(Paragraph{
      Phrase(
          "The function energy(inertia, omega) computes T = ½ ω·Iω from the inertia and the "
          "angular velocity in body axes. For an attitude X, ω = I⁻¹XᵀL. The experiments of "
          "task 5 begin with the energies:",
          "Funksjonen energy(inertia, omega) regner ut T = ½ ω·Iω fra treghetsmomentet og "
          "vinkelhastigheten i legemets akser. For en stilling X er ω = I⁻¹XᵀL. Eksperimentene i "
          "oppgave 5 starter med disse energiene:")
          .in(language)});
  section.content.emplace_back(energy_table(solutions));
  add_inertia(section, solutions.front().solution, citations);
  return section;
}

}  // namespace twrench::report

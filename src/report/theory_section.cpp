#include <twrench/motion/method.h>

#include "report/sections.h"

namespace twrench::report {
namespace {

void add_motion(Section& section, Language language, Citations& citations) {
  const std::string specification = citations.specification();
  section.content.emplace_back(
      Subheading{Phrase("The body and its motion", "Legemet og bevegelsen").in(language)});
  section.content.emplace_back(formula(
      "momentum",
      Phrase(
          "The attitude X is the rotation matrix whose columns are the body axes in space: it "
          "takes "
          "body coordinates to space coordinates. I is the inertia matrix about the centre of mass "
          "in body axes, g cm², eq. (13) of {0}, and ω the angular velocity in body axes, rad/s. L "
          "is the angular momentum in space axes, g cm²/s, eq. (12), and T the rotational kinetic "
          "energy, g cm²/s², eq. (14), which {0} calls K {1}. Without a torque both are constant.",
          "Stillingen X er rotasjonsmatrisen som har legemets akser i rommet som søyler: Den tar "
          "legemets koordinater til rommets koordinater. I er treghetsmatrisen om massesenteret i "
          "legemets akser, g cm², likning (13) i {0}, og ω er vinkelhastigheten i legemets akser, "
          "rad/s. L er dreieimpulsen (spinnet) i rommets akser, g cm²/s, likning (12), og T den "
          "kinetiske rotasjonsenergien, g cm²/s², likning (14); i {0} heter de dreiemomentet og K "
          "{1}. Uten kraftmoment er begge konstante.")
          .in(language, specification, citations.cite(feynman))));
  section.content.emplace_back(formula(
      "motion",
      Phrase("The equations of motion, eq. (18)-(20) of {}. The dot is the derivative with respect "
             "to the time t, Xᵀ the transpose, and X(0) = Id, the identity. The hat makes a matrix "
             "of a vector such that ω̂ v = ω × v for every vector v. The solution stays in SO(3), "
             "the group of the rotation matrices: XᵀX = Id.",
             "Bevegelseslikningene, likning (18)-(20) i {}. Prikken er den deriverte med hensyn på "
             "tiden t, Xᵀ er den transponerte, og X(0) = Id er identitetsmatrisen. Hatten gjør en "
             "vektor om til en matrise, hattmatrisen, slik at ω̂ v = ω × v for alle vektorer v. "
             "Løsningen blir værende i SO(3), gruppen av rotasjonsmatriser: XᵀX = Id.")
          .in(language, specification)));
  section.content.emplace_back(formula(
      "exponential",
      Phrase("The rotation by the angle wh about ω, eq. (21) of {}. For constant ω, X exp(hΩ) is "
             "the attitude a time h after X; it is again a rotation, eq. (22).",
             "Rotasjonen med vinkelen wh om ω, likning (21) i {}. For konstant ω er X exp(hΩ) "
             "stillingen en tid h etter X; den er igjen en rotasjon, likning (22).")
          .in(language, specification)));
}

void add_methods(Section& section, Language language, Citations& citations) {
  const std::string specification = citations.specification();
  section.content.emplace_back(Subheading{Phrase("The methods", "Metodene").in(language)});
  section.content.emplace_back(formula(
      "lie_euler",
      Phrase(
          "The Lie-Euler method, eq. (25) of {}. W approximates X before a step of the length "
          "h, W′ after it. Euler's method, eq. (24), W′ = W + hWΩ, leaves SO(3); Lie-Euler "
          "cannot.",
          "Lie-Euler-metoden, likning (25) i {}. W er tilnærmingen til X før et steg med lengden "
          "h, W′ etter steget. Eulers metode, likning (24), W′ = W + hWΩ, forlater SO(3); det "
          "kan ikke Lie-Euler gjøre.")
          .in(language, specification)));
  section.content.emplace_back(formula(
      "rk4",
      Phrase(
          "RK4, section 4.4 of {}. The s are the angular velocities of four stages; S is the "
          "hat of s.",
          "RK4, avsnitt 4.4 i {}. s-ene er vinkelhastighetene i fire trinn; S er hattmatrisen til "
          "s.")
          .in(language, specification)));
  section.content.emplace_back(formula(
      "rkf45",
      Phrase(
          "RKF45, section 4.5 of {0}, with Fehlberg's coefficients a, b and c, eq. (39), of "
          "six stages. The norm with the index F is Frobenius', the square root of the sum of the "
          "squares of the entries. E estimates the error of the step, which is accepted if E is "
          "below the tolerance τ. The next step is 0.8 (τ/E)^(1/5) times as long, within bounds "
          "{1}.",
          "RKF45, avsnitt 4.5 i {0}, med Fehlbergs koeffisienter a, b og c, likning (39), for seks "
          "trinn. Normen med indeksen F er Frobenius-normen, kvadratroten av summen av kvadratene "
          "av elementene. E er et estimat av feilen i steget, som godtas hvis E er under "
          "toleransen "
          "τ. Det neste steget er 0.8 (τ/E)^(1/5) ganger så langt, innenfor visse grenser {1}.")
          .in(language, specification, citations.cite(sauer))));
}

void add_products(Section& section, Language language, Citations& citations) {
  const std::string introduction = citations.cite(lie_integrators);
  section.content.emplace_back(formula(
      "coordinates",
      Phrase(
          "The equation of the coordinates u of the attitude within a step {0}. RK4 and RKF45 of "
          "{1} average the velocities s. They therefore solve u̇ = ω and leave out the products. "
          "The "
          "first of these adds (h³/12) ω × ω̇ to each step, whatever the number of stages and the "
          "weights, so both methods are of second order. The methods rkmk4 and rkmk45 have the "
          "same "
          "coefficients and keep the products {2}.",
          "Likningen for koordinatene u til stillingen innenfor et steg {0}. RK4 og RKF45 i {1} "
          "tar gjennomsnittet av vinkelhastighetene s. De løser derfor u̇ = ω og utelater "
          "produktene. Det første av dem legger (h³/12) ω × ω̇ til hvert steg, uansett antall trinn "
          "og uansett vektene, så begge metodene er av andre orden. Metodene rkmk4 og rkmk45 har "
          "de "
          "samme koeffisientene og beholder produktene {2}.")
          .in(language, introduction, citations.specification(),
              citations.cite_method(motion::find_method("rkmk4").source))));
}

void add_exact_motion(Section& section, Language language, Citations& citations) {
  const std::string jacobi = citations.cite_method(motion::find_method("exact").source);
  section.content.emplace_back(
      Subheading{Phrase("The exact motion and its flips", "Den eksakte bevegelsen og vendingene")
                     .in(language)});
  section.content.emplace_back(formula(
      "moments",
      Phrase(
          "In the principal axes, with the moments I₁ to I₃, the motion is known in closed "
          "form: ω consists of Jacobi's elliptic functions of λt {} {}. D₁ is never negative and "
          "D₃ never positive. L circles the axis of least moment if D₂ < 0, that of greatest "
          "moment if D₂ > 0. At D₂ = 0, the separatrix, it circles neither.",
          "I hovedaksene, med treghetsmomentene I₁ til I₃, er bevegelsen kjent på lukket form: ω "
          "består av Jacobis elliptiske funksjoner av λt {} {}. D₁ er aldri negativ og D₃ aldri "
          "positiv. L kretser om aksen med minst treghetsmoment hvis D₂ < 0, og om aksen med "
          "størst hvis D₂ > 0. For D₂ = 0, på separatrisen, kretser den ikke om noen av dem.")
          .in(language, jacobi, citations.cite(landau))));
  section.content.emplace_back(formula(
      "closed_form",
      Phrase("λ is the rate of the argument, 1/s, m the parameter of the elliptic functions, and A "
             "the largest |ω₂|, rad/s, where ω₂ is the component of ω along the intermediate axis: "
             "ω₂ = ±A sn(λ(t − t₁), m).",
             "λ er endringsraten til argumentet, 1/s, m parameteren til de elliptiske "
             "funksjonene, og A den største |ω₂|, rad/s, der ω₂ er komponenten av ω "
             "langs den midterste aksen: ω₂ = ±A sn(λ(t − t₁), m).")
          .in(language)));
  section.content.emplace_back(
      formula("flips",
              Phrase("The times of the flips, where ω₂ changes sign. F is the elliptic integral of "
                     "the first kind, K the complete one. Near the separatrix 2K/λ tends to "
                     "ln(16/(1 − m))/λ.",
                     "Tidspunktene for vendingene, der ω₂ skifter fortegn. F er det elliptiske "
                     "integralet av første slag, K det fullstendige. Nær separatrisen går 2K/λ mot "
                     "ln(16/(1 − m))/λ.")
                  .in(language)));
  section.content.emplace_back(formula(
      Phrase("first_flip_en", "first_flip_nb").in(language),
      Phrase("The first flip, and the swing θ with the index s: the angle through which the "
             "intermediate axis swings from one side of the plane normal to L to the other. The "
             "body turns over if the swing is at least 120 degrees; otherwise it wobbles.",
             "Den første vendingen, og utslaget θ med indeksen s: vinkelen som den midterste aksen "
             "svinger gjennom fra den ene siden av planet normalt på L til den andre. Legemet snur "
             "hvis utslaget er minst 120 grader; ellers slingrer det.")
          .in(language)));
}

void add_interior(Section& section, Language language, Citations& citations) {
  section.content.emplace_back(
      Subheading{Phrase("A wheel and energy loss", "Svinghjul og energitap").in(language)});
  section.content.emplace_back(formula(
      "interior",
      Phrase(
          "The rate ω at which X turns if the body contains a wheel and loses energy {}. m is "
          "the momentum in body axes, h that of the wheel relative to the body, constant in body "
          "axes, g cm²/s, and a ≥ 0 the coefficient of the energy loss, s/(g cm²). L stays "
          "constant. T does not contain the constant energy of the wheel. The rates at t = 0 in "
          "the tables are those of w.",
          "Vinkelhastigheten ω som X dreier med hvis legemet inneholder et svinghjul og taper "
          "energi {}. m er dreieimpulsen i legemets akser, h er svinghjulets dreieimpuls i "
          "forhold til legemet, konstant i legemets akser, g cm²/s, og a ≥ 0 er koeffisienten "
          "for energitapet, s/(g cm²). L forblir konstant. Den konstante energien til svinghjulet "
          "er ikke med i T. Vinkelhastighetene ved t = 0 i tabellene gjelder w.")
          .in(language, citations.cite(double_bracket))));
  section.content.emplace_back(formula(
      "nutation",
      Phrase("Without a wheel, the amplitude of a small nutation about the axis of greatest moment "
             "decays with the time constant τ.",
             "Uten svinghjul avtar amplituden til en liten nutasjon om aksen med størst "
             "treghetsmoment med tidskonstanten τ.")
          .in(language)));
}

void add_errors(Section& section, Language language) {
  section.content.emplace_back(Subheading{Phrase("Errors", "Feil").in(language)});
  section.content.emplace_back(formula(
      Phrase("errors_en", "errors_nb").in(language),
      Phrase(
          "The error of the attitude, the energy drift (T₀ is the energy at t = 0), the distance "
          "from SO(3), and the error of the momentum. Drifts are the largest of all steps. A "
          "method has the order p if its error of X, over a given time, is proportional to h to "
          "the power p; a measured order is the median slope of the logarithm of the error over "
          "that of h.",
          "Feilen i stillingen, energidriften (T₀ er energien ved t = 0), "
          "avstanden fra SO(3) og feilen i dreieimpulsen. Oppgitt drift er den "
          "største av alle steg. En metode har orden p hvis feilen i X, over en "
          "gitt tid, er proporsjonal med h opphøyd i p; en målt orden er medianen "
          "av stigningstallene til logaritmen av feilen mot logaritmen av h.")
          .in(language)));
}

}  // namespace

Section theory_section(Language language, Citations& citations, bool has_interior) {
  Section section{.heading = Phrase("Theory and methods", "Teori og metoder").in(language),
                  .content = {}};
  add_motion(section, language, citations);
  add_methods(section, language, citations);
  add_products(section, language, citations);
  add_exact_motion(section, language, citations);
  if (has_interior) add_interior(section, language, citations);
  add_errors(section, language);
  return section;
}

}  // namespace twrench::report

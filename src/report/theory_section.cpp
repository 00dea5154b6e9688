#include <fmt/format.h>
#include <twrench/motion/method.h>

#include "report/sections.h"

namespace twrench::report {
namespace {

void add_motion(Section& section, Citations& citations) {
  const std::string specification = citations.specification();
  section.content.emplace_back(Subheading{"The body and its motion"});
  section.content.emplace_back(Formula{
      R"(L = X I \omega ,\quad T = \frac{1}{2} \omega \cdot I \omega)",
      fmt::format(
          "The attitude X is the rotation matrix whose columns are the body axes in space: it "
          "takes "
          "body coordinates to space coordinates. I is the inertia matrix about the centre of mass "
          "in body axes, g cm², eq. (13) of {0}, and ω the angular velocity in body axes, rad/s. L "
          "is the angular momentum in space axes, g cm²/s, eq. (12), and T the rotational kinetic "
          "energy, g cm²/s², eq. (14), which {0} calls K {1}. Without a torque both are constant.",
          specification, citations.cite(feynman))});
  section.content.emplace_back(Formula{
      R"(\dot X = X \Omega ,\quad \omega = I^{-1} X^T L ,\quad \Omega = \hat \omega = )"
      R"(\begin{pmatrix} 0 & -\omega_z & \omega_y \\ \omega_z & 0 & -\omega_x \\ )"
      R"(-\omega_y & \omega_x & 0 \end{pmatrix})",
      fmt::format("The equations of motion, eq. (18)-(20) of {}. The dot is the derivative with "
                  "respect to the time t, Xᵀ the transpose, and X(0) = Id, the identity. The hat "
                  "makes a matrix of a vector such that ω̂ v = ω × v for every vector v. The "
                  "solution stays in SO(3), the group of the rotation matrices: XᵀX = Id.",
                  specification)});
  section.content.emplace_back(Formula{
      R"(\exp(h \Omega) = \mathrm{Id} + \frac{\sin w h}{w} \Omega + \frac{1 - \cos w h}{w^2} )"
      R"(\Omega^2 ,\quad w = |\omega|)",
      fmt::format("The rotation by the angle wh about ω, eq. (21) of {}. For constant ω, "
                  "X exp(hΩ) is the attitude a time h after X; it is again a rotation, eq. (22).",
                  specification)});
}

void add_methods(Section& section, Citations& citations) {
  const std::string specification = citations.specification();
  section.content.emplace_back(Subheading{"The methods"});
  section.content.emplace_back(Formula{
      R"(W' = W \exp(h \Omega) ,\quad \omega = I^{-1} W^T L)",
      fmt::format("The Lie-Euler method, eq. (25) of {}. W approximates X before a step of the "
                  "length h, W′ after it. Euler's method, eq. (24), W′ = W + hWΩ, leaves SO(3); "
                  "Lie-Euler cannot.",
                  specification)});
  section.content.emplace_back(Formula{
      R"(\begin{aligned} s_1 &= I^{-1} W^T L ,\quad s_2 = I^{-1} \exp\left(-\frac{h}{2} S_1\right) )"
      R"(W^T L ,\quad s_3 = I^{-1} \exp\left(-\frac{h}{2} S_2\right) W^T L , \\ )"
      R"(s_4 &= I^{-1} \exp(-h S_3) W^T L ,\quad W' = W \exp\left(\frac{h}{6} )"
      R"((S_1 + 2 S_2 + 2 S_3 + S_4)\right) \end{aligned})",
      fmt::format("RK4, section 4.4 of {}. The s are the angular velocities of four stages; S is "
                  "the hat of s.",
                  specification)});
  section.content.emplace_back(Formula{
      R"(\begin{aligned} s_k &= I^{-1} \exp\left(-h \sum_j a_{kj} S_j\right) W^T L ,\quad )"
      R"(W' = W \exp\left(h \sum_k b_k S_k\right) , \\ Z' &= W \exp\left(h \sum_k c_k S_k\right) )"
      R"(,\quad E = \|W' - Z'\|_F \end{aligned})",
      fmt::format(
          "RKF45, section 4.5 of {0}, with Fehlberg's coefficients a, b and c, eq. (39), of "
          "six stages. The norm with the index F is Frobenius', the square root of the sum of the "
          "squares of the entries. E estimates the error of the step, which is accepted if E is "
          "below the tolerance τ. The next step is 0.8 (τ/E)^(1/5) times as long, within bounds "
          "{1}.",
          specification, citations.cite(sauer))});
}

void add_products(Section& section, Citations& citations) {
  const std::string introduction = citations.cite(lie_integrators);
  section.content.emplace_back(Formula{
      R"(\dot u = \omega + \frac{1}{2} u \times \omega + \frac{1 - (\theta / 2) \cot(\theta / 2)})"
      R"({\theta^2} u \times (u \times \omega) ,\quad X = W \exp(\hat u) ,\quad \theta = |u|)",
      fmt::format(
          "The equation of the coordinates u of the attitude within a step {0}. RK4 and RKF45 of "
          "{1} "
          "average the velocities s. They therefore solve u̇ = ω and leave out the products. The "
          "first of these adds (h³/12) ω × ω̇ to each step, whatever the number of stages and the "
          "weights, so both methods are of second order. The methods rkmk4 and rkmk45 have the "
          "same "
          "coefficients and keep the products {2}.",
          introduction, citations.specification(),
          citations.cite_method(motion::find_method("rkmk4").source))});
}

void add_exact_motion(Section& section, Citations& citations) {
  const std::string jacobi = citations.cite_method(motion::find_method("exact").source);
  section.content.emplace_back(Subheading{"The exact motion and its flips"});
  section.content.emplace_back(Formula{
      R"(D_i = G^2 - 2 T I_i ,\quad G = |L| ,\quad I_1 \le I_2 \le I_3)",
      fmt::format("In the principal axes, with the moments I₁ to I₃, the motion is known in closed "
                  "form: ω consists of Jacobi's elliptic functions of λt {} {}. D₁ is never "
                  "negative and D₃ never positive. L circles the axis of least moment if D₂ < 0, "
                  "that of greatest moment if D₂ > 0. At D₂ = 0, the separatrix, it circles "
                  "neither.",
                  jacobi, citations.cite(landau))});
  section.content.emplace_back(Formula{
      R"(\begin{aligned} D_2 < 0: \quad & \lambda = \sqrt{\frac{(I_2 - I_1) |D_3|}{I_1 I_2 I_3}} )"
      R"(,\quad 1 - m = \frac{|D_2| (I_3 - I_1)}{|D_3| (I_2 - I_1)} ,\quad )"
      R"(A = \sqrt{\frac{D_1}{I_2 (I_2 - I_1)}} \\ D_2 > 0: \quad & )"
      R"(\lambda = \sqrt{\frac{(I_3 - I_2) D_1}{I_1 I_2 I_3}} ,\quad )"
      R"(1 - m = \frac{D_2 (I_3 - I_1)}{D_1 (I_3 - I_2)} ,\quad )"
      R"(A = \sqrt{\frac{|D_3|}{I_2 (I_3 - I_2)}} \end{aligned})",
      "λ is the rate of the argument, 1/s, m the parameter of the elliptic functions, and A the "
      "largest |ω₂|, rad/s, where ω₂ is the component of ω along the intermediate axis: "
      "ω₂ = ±A sn(λ(t − t₁), m)."});
  section.content.emplace_back(
      Formula{R"(t_n = t_1 + (n - 1) \frac{2 K(m)}{\lambda} ,\quad K(m) = F(\pi / 2, m) ,\quad )"
              R"(F(\varphi, m) = \int_0^{\varphi} \frac{d \theta}{\sqrt{1 - m \sin^2 \theta}})",
              "The times of the flips, where ω₂ changes sign. F is the elliptic integral of the "
              "first kind, "
              "K the complete one. Near the separatrix 2K/λ tends to ln(16/(1 − m))/λ."});
  section.content.emplace_back(Formula{
      R"(t_1 = \begin{cases} F(\varphi, m) / \lambda & \text{if } |\omega_2| \text{ decreases at } )"
      R"(t = 0 \\ (2 K(m) - F(\varphi, m)) / \lambda & \text{if not} \end{cases} )"
      R"(\quad \sin \varphi = \frac{|\omega_2(0)|}{A} ,\quad \sin \frac{\theta_s}{2} = )"
      R"(\frac{I_2 A}{G})",
      "The first flip, and the swing θ with the index s: the angle through which the intermediate "
      "axis swings from one side of the plane normal to L to the other. The body turns over if the "
      "swing exceeds a right angle; otherwise it wobbles."});
}

void add_interior(Section& section, Citations& citations) {
  section.content.emplace_back(Subheading{"A wheel and energy loss"});
  section.content.emplace_back(Formula{
      R"(\begin{aligned} w &= I^{-1} (m - h) ,\quad m = X^T L ,\quad \omega = w + a (m \times w) )"
      R"(, \\ T &= \frac{1}{2} w \cdot I w ,\quad \dot T = - a |m \times w|^2 \end{aligned})",
      fmt::format("The rate ω at which X turns if the body contains a wheel and loses energy {}. m "
                  "is the momentum in body axes, h that of the wheel relative to the body, "
                  "constant in body axes, g cm²/s, and a ≥ 0 the coefficient of the energy loss, "
                  "s/(g cm²). L stays constant. T does not contain the constant energy of the "
                  "wheel. The rates at t = 0 in the tables are those of w.",
                  citations.cite(double_bracket))});
  section.content.emplace_back(Formula{
      R"(a = \frac{2}{\tau G^2 (1 / I_1 + 1 / I_2 - 2 / I_3)} ,\quad G = |L|)",
      "Without a wheel, the amplitude of a small nutation about the axis of greatest moment decays "
      "with the time constant τ."});
}

void add_errors(Section& section) {
  section.content.emplace_back(Subheading{"Errors"});
  section.content.emplace_back(Formula{
      R"(e_X = \|X - X_{\text{exact}}\|_F ,\quad e_T = |T / T_0 - 1| ,\quad )"
      R"(e_{SO(3)} = \|X^T X - \mathrm{Id}\|_F ,\quad e_L = |X I \omega - L| / |L|)",
      "The error of the attitude, the energy drift (T₀ is the energy at t = 0), the distance from "
      "SO(3), and the error of the momentum. Drifts are the largest of all steps. A method has the "
      "order p if its error of X, over a given time, is proportional to h to the power p; a "
      "measured "
      "order is the median slope of the logarithm of the error over that of h."});
}

}  // namespace

Section theory_section(Citations& citations, bool has_interior) {
  Section section{.heading = "Theory and methods", .content = {}};
  add_motion(section, citations);
  add_methods(section, citations);
  add_products(section, citations);
  add_exact_motion(section, citations);
  if (has_interior) add_interior(section, citations);
  add_errors(section);
  return section;
}

}  // namespace twrench::report

#include "check/report/law_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "check/report/alternative_text.h"
#include "check/report/result.h"

namespace twrench::check {
namespace {

/// "2.5 +- 0.01", or the number alone if its deviation is tiny.
std::string number_text(double value, double deviation) {
  constexpr double tiny = 1e-6;
  if (!(std::abs(deviation) > tiny * std::abs(value))) return fmt::format("{:.6g}", value);
  return fmt::format("{:.4g} +- {:.1g}", value, deviation);
}

/// The value of a mistake with a single number.
std::string number_text(const Explanation& explanation) {
  return number_text(explanation.value[0], explanation.deviation[0]);
}

std::string vector_text(const Eigen::Vector3d& value, const Eigen::VectorXd& deviation) {
  std::vector<std::string> numbers;
  const double negligible = 1e-6 * value.norm();
  for (int i = 0; i < 3; ++i) {
    const bool is_zero = std::abs(value[i]) < std::max(negligible, 3 * deviation[i]);
    numbers.push_back(is_zero ? "0" : number_text(value[i], deviation[i]));
  }
  return fmt::format("({})", fmt::join(numbers, ", "));
}

std::string factor_text(const Explanation& explanation) {
  const double factor = explanation.value[0];
  if (explanation.free_numbers > 0)
    return "the gyroscopic term is multiplied by " + number_text(explanation);
  if (factor == 0) return "the gyroscopic term of Euler's equations is missing";
  if (factor == -1) return "the gyroscopic term has the wrong sign";
  return factor < 1 ? "the gyroscopic term is halved" : "the gyroscopic term is doubled";
}

/// Names the factor of the attitude that gives the same motion as the factor of the gyroscopic
/// term, if there are attitudes alone.
std::string same_text(const Judgement& judgement, const Explanation& explanation) {
  const double factor = explanation.value[0];
  if (judgement.has_rates || factor == 0) return {};
  return fmt::format(
      ", or, which is the same motion, the attitude turns {:.6g} times as fast as it should",
      1 / factor);
}

std::string division_text(const Explanation& explanation, const char* how) {
  std::string text = fmt::format("the gyroscopic term is {}", how);
  if (explanation.free_numbers > 0)
    text += fmt::format(", apart from the factor {}", number_text(explanation));
  return text;
}

std::string torque_text(const Explanation& explanation, const Eigen::Vector3d& torque,
                        const char* axes) {
  return fmt::format("a constant torque acts, {} in {}, in the unit of the moments times rad/s^2",
                     vector_text(torque, explanation.deviation), axes);
}

std::string attitude_factor_text(const Explanation& explanation) {
  const double factor = explanation.value[0];
  if (explanation.free_numbers > 0)
    return fmt::format("the attitude turns {} times as fast as the rates say",
                       number_text(explanation));
  if (factor == 2) {
    return "the attitude turns twice as fast as the rates say, as if the factor 1/2 in the "
           "equation of the quaternion, q' = 1/2 q w, were missing";
  }
  if (factor == 0.5) {
    return "the attitude turns half as fast as the rates say, as if the factor 1/2 in the "
           "equation of the quaternion, q' = 1/2 q w, were applied twice";
  }
  if (factor == 0) return "the attitude does not turn";
  return "the attitude turns against the rates, as if the quaternion were conjugated on one side "
         "of its equation";
}

std::string swapped_text(const Explanation& explanation) {
  std::string text =
      "the attitude takes the rates, which are in the body's axes, for rates in space, as if the "
      "factors in X' = X hat(w) or q' = 1/2 q w were swapped";
  if (explanation.value.size() > 0 && explanation.value[0] != 1)
    text += fmt::format(", and turns {} times as fast", number_text(explanation));
  return text;
}

std::string delay_text(const Judgement& judgement, const Explanation& explanation) {
  const double delay = explanation.law.delay;
  const double step = judgement.duration / static_cast<double>(judgement.rows - 1);
  std::string text = fmt::format("the attitude follows the rates of {:.6g} s {}", std::abs(delay),
                                 delay > 0 ? "before" : "later");
  if (explanation.free_numbers == 0)
    text += std::abs(delay) < 0.75 * step ? ", half an interval" : ", one interval";
  return text;
}

std::string angles_text(const Explanation& explanation) {
  std::string sequence;
  for (const int axis : explanation.law.sequence) sequence += "xyz"[axis];
  return fmt::format(
      "the attitude integrates the rates as if they were the derivatives of Euler "
      "angles in the sequence {}",
      sequence);
}

std::string limit_text(const Judgement& judgement, const Explanation& explanation) {
  const RateScale unit = rate_scale(judgement);
  return fmt::format("the angular velocity is limited to {} {}",
                     number_text(explanation.value[0] * unit.per_radian,
                                 explanation.deviation[0] * unit.per_radian),
                     unit.symbol);
}

/// The moments of the body whose motion the rows follow.
std::string body_text(const Judgement& judgement, const Eigen::Matrix3d& inertia) {
  const motion::FreeBody found(inertia, Eigen::Vector3d::Zero());
  const auto text = [](const motion::FreeBody& body) {
    const Eigen::Vector3d& moments = body.principal().moments;
    return fmt::format("1 : {:.6g} : {:.6g}", moments[1] / moments[0], moments[2] / moments[0]);
  };
  return fmt::format(
      "the principal moments fit in the ratio {}, but those given are in the ratio {}", text(found),
      text(judgement.reference.body));
}

std::string cause_text(const Judgement& judgement, const Explanation& explanation) {
  const Law& law = explanation.law;
  switch (explanation.mistake) {
    case Mistake::gyroscopic_factor:
      return factor_text(explanation) + same_text(judgement, explanation);
    case Mistake::undivided:
      return division_text(explanation, "not divided by the moments");
    case Mistake::multiplied:
      return division_text(explanation, "multiplied by the moments instead of divided by them");
    case Mistake::body_torque:
      return torque_text(explanation, law.body_torque, "the body's axes");
    case Mistake::space_torque:
      return torque_text(explanation, law.space_torque, "the axes of space");
    case Mistake::damping:
      return fmt::format("the rates are damped by {} per second: they {} in {:.4g} s",
                         number_text(explanation), law.damping > 0 ? "fall to 1/e" : "grow to e",
                         1 / std::abs(law.damping));
    case Mistake::quadratic_damping:
      return fmt::format("the rates are damped in proportion to their square, by {} per radian",
                         number_text(explanation));
    case Mistake::speed_limit:
      return limit_text(judgement, explanation);
    case Mistake::products_sign:
      return "the products of inertia have the other sign";
    case Mistake::inverse_inertia:
      return "the body has the inverse of the inertia";
    case Mistake::moments:
      return body_text(judgement, law.inertia);
    case Mistake::attitude_factor:
      return attitude_factor_text(explanation);
    case Mistake::swapped_factors:
      return swapped_text(explanation);
    case Mistake::delayed_rates:
      return delay_text(judgement, explanation);
    case Mistake::integrated_angles:
      return angles_text(explanation);
  }
  return {};
}

std::string text_of(const Judgement& judgement, const std::vector<Explanation>& all,
                    const char* what) {
  if (all.empty()) return {};
  std::vector<std::string> causes;
  for (const Explanation& one : all) causes.push_back(cause_text(judgement, one));
  const double miss = all.front().miss;
  const std::string size = miss > 0 ? fmt::format("to {:.1g} of what changes", miss) : "exactly";
  return fmt::format("{}; with this, {} {}", joined(causes, "; or "), what, size);
}

}  // namespace

std::string law_text(const Judgement& judgement, const WrongLaws& laws) {
  std::vector<std::string> texts;
  for (const std::string& text :
       {text_of(judgement, laws.of_rates,
                judgement.has_rates ? "the rates agree" : "the rates of the attitude agree"),
        text_of(judgement, laws.of_attitude, "the attitude agrees")}) {
    if (!text.empty()) texts.push_back(text);
  }
  constexpr double much = 0.05;
  if (laws.of_attitude.empty() && laws.attitude_miss > much)
    texts.push_back(
        fmt::format("the attitude then still misses {:.2g} of what changes", laws.attitude_miss));
  return joined(texts, "; and ");
}

}  // namespace twrench::check

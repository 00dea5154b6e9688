#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/check_result.h"

namespace twrench::app {
namespace {

using check::Judgement;

std::string joined(const std::vector<std::string>& parts, std::string_view between) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : std::string(between)) + part;
  return text;
}

const char* unit_word(check::Angle unit) { return unit == check::Angle::degrees ? "deg" : "rad"; }

/// The moments that were given, in the order 1,0,2, say.
std::string moments_text(const Judgement& judgement, const std::array<int, 3>& order) {
  const Eigen::Vector3d moments = judgement.reference.body.inertia().diagonal();
  return fmt::format("--inertia {},{},{}", moments[order[0]], moments[order[1]], moments[order[2]]);
}

/// "with --units deg", "without --inverse".
std::string proposal_text(const CheckedFile& file) {
  const check::Reading& reading = *file.proposal;
  const check::Convention& before = file.judgement.convention;
  const bool drops_inverse = before.inverse && !reading.convention.inverse;
  const std::string options = option_text(before, reading.convention);
  if (options.empty() && !drops_inverse) {
    return "with " + moments_text(file.judgement, reading.moment_order);
  }
  std::vector<std::string> parts;
  if (!options.empty()) parts.push_back("with " + options);
  if (drops_inverse) parts.emplace_back("without --inverse");
  return joined(parts, ", ");
}

std::string foreign_text(const CheckedFile& file) {
  const Judgement& judgement = file.judgement;
  if (file.proposal) {
    return "as read, it does not follow this body's motion, but it does " + proposal_text(file);
  }
  const check::Misfit& misfit = judgement.misfit;
  if (misfit.constant_rates) {
    return "does not follow this body's motion: its rates never change, as if the gyroscopic term "
           "of Euler's equations were missing";
  }
  const bool rates_fit = check::Misfit{misfit.rates, {}}.fits();
  if (misfit.rates && misfit.attitude && rates_fit) {
    return "attitude and rates are inconsistent in every frame and unit, though the rates follow "
           "this body's motion";
  }
  if (!judgement.has_attitude) {
    return "does not follow this body's motion in either unit (without an attitude, rates in space "
           "axes cannot be recognised)";
  }
  return "does not follow this body's motion in any unit or frame";
}

/// "x, y and z": the unit vector of a rate to three places.
std::string direction_text(const Eigen::Vector3d& rate) {
  const Eigen::Vector3d n = rate.normalized();
  const auto places = [](double value) {
    return fmt::format("{:.3f}", std::round(1e3 * value) / 1e3 + 0.0);  // no minus before 0
  };
  return fmt::format("({}, {}, {})", places(n.x()), places(n.y()), places(n.z()));
}

std::string contradiction_text(const Judgement& judgement) {
  std::string text = fmt::format(
      "attitude and rates are inconsistent: the attitude is off by up to {:.3g} deg, more than "
      "the errors of the rates explain",
      degrees(judgement.attitude->max));
  const check::FrameTurn& turn = judgement.frame_turn;
  constexpr double steady = 0.99;
  if (turn.share < steady) return text;
  const Eigen::Vector3d L = judgement.reference.frame * judgement.reference.body.momentum();
  if (std::abs(turn.rate.normalized().dot(L.normalized())) > steady) {
    return text + fmt::format(
                      ", by {:.3g} deg/s about L, as when it is integrated less accurately "
                      "than the rates",
                      degrees(turn.rate.norm()));
  }
  text += fmt::format(
      ", as in a reference frame that itself rotates at {:.4g} deg/s about {} in space axes",
      degrees(turn.rate.norm()), direction_text(turn.rate));
  constexpr double earth = 7.292115e-5;  // rad/s, sidereal
  if (std::abs(turn.rate.norm() / earth - 1) < 0.02) text += " (the Earth's rate)";
  return text;
}

/// What most of the error is.
std::string cause_text(const Judgement& judgement) {
  if (!judgement.parts) return {};
  const check::ErrorParts& parts = *judgement.parts;
  // Only the rates tell the two apart in one unit; they stand for the attitude too.
  const double phase = parts.phase_rate, amplitude = parts.amplitude_rate;
  constexpr double mostly = 3;
  const std::string delay =
      fmt::format("it runs {:.3g} s {}", std::abs(parts.delay), parts.delay > 0 ? "late" : "early");
  const std::string level = fmt::format("energy off by {:.2g}", judgement.energy_error);
  if (phase > mostly * amplitude) {
    return fmt::format("; mostly phase: {}, energy is conserved to {:.2g}", delay,
                       judgement.energy_drift);
  }
  if (amplitude > mostly * phase) return "; mostly amplitude: " + level;
  return fmt::format("; phase and amplitude: {}, {}", delay, level);
}

std::string sizes_text(const Judgement& judgement) {
  std::vector<std::string> sizes;
  if (judgement.rates) {
    const RateUnit unit = rate_unit(judgement);
    sizes.push_back(fmt::format("{:.3g} {} at {:.10g} s", judgement.rates->max * unit.per_radian,
                                unit.name, judgement.rates->at));
  }
  if (judgement.attitude && !judgement.attitude_contradicts_rates) {
    sizes.push_back(fmt::format("{:.3g} deg at {:.10g} s", degrees(judgement.attitude->max),
                                judgement.attitude->at));
  }
  return joined(sizes, " and ");
}

/// The largest error in units of the resolution limit at its time.
double beyond_digits(const Judgement& judgement) {
  double most = 0;
  for (const check::Span& span : judgement.course) {
    if (judgement.has_rates) most = std::max(most, span.rate_error / span.rate_limit);
    if (judgement.has_attitude && !judgement.attitude_contradicts_rates) {
      most = std::max(most, span.attitude_error / span.attitude_limit);
    }
  }
  return most;
}

/// Whether the first row is not in the state that was given, and that explains the later errors.
bool begins_otherwise(const Judgement& judgement) {
  const double error = judgement.first_rate_error;
  constexpr double at_least_mostly = 3;
  return !judgement.fit && !judgement.within_digits &&
         error > judgement.course.front().rate_limit &&
         at_least_mostly * judgement.growth.rates * error > judgement.rates->max;
}

std::string beginning_text(const Judgement& judgement) {
  const RateUnit unit = rate_unit(judgement);
  return fmt::format(
      "starts from another state: its first row is already off by {:.3g} {}, which grows to "
      "explain the largest error, {}",
      judgement.first_rate_error * unit.per_radian, unit.name, sizes_text(judgement));
}

bool rates_within_digits(const Judgement& judgement) {
  return std::ranges::all_of(
      judgement.course, [](const check::Span& span) { return span.rate_error <= span.rate_limit; });
}

std::string faultless_text(const Judgement& judgement) {
  const std::string text =
      fmt::format("off by at most {}, within the resolution of its digits", sizes_text(judgement));
  constexpr double much_of_the_motion = 0.1;
  const double speed = judgement.reference.body.omega().norm();
  const bool says_little = judgement.has_rates ? judgement.rate_limit > much_of_the_motion * speed
                                               : judgement.attitude_limit > much_of_the_motion;
  return says_little ? text + "; but by the end almost any motion would be" : text;
}

/// Whether the attitudes are farther from rotations than their errors and their digits explain.
bool is_no_rotation(const Judgement& judgement) {
  if (!judgement.orthogonality_error) return false;
  constexpr double margin = 10, round_off = 1e-14;
  const double explained =
      std::max({judgement.attitude->max, judgement.digits.attitude, round_off});
  return *judgement.orthogonality_error > margin * explained;
}

std::string no_rotation_text(const Judgement& judgement) {
  const char* const difference =
      check::attitude_form(judgement.convention) == check::AttitudeForm::matrix
          ? "matrices are not rotations: X^T X differs from the identity"
          : "quaternions are not of unit length: the squared length differs from 1";
  return fmt::format("its {} by up to {:.3g}; apart from that, it is ", difference,
                     *judgement.orthogonality_error);
}

std::string error_text(const Judgement& judgement) {
  return fmt::format(
      "off by up to {}, and by up to {:.3g} times the resolution limit of its digits{}",
      sizes_text(judgement), beyond_digits(judgement), cause_text(judgement));
}

}  // namespace

RateUnit rate_unit(const Judgement& judgement) {
  if (judgement.rate_unit == check::Angle::degrees) {
    return {180 / std::numbers::pi, "deg/s", "deg"};
  }
  return {1, "rad/s", "rad"};
}

double degrees(double angle) { return angle * (180 / std::numbers::pi); }

std::string option_text(const check::Convention& before, const check::Convention& after) {
  std::vector<std::string> options;
  if (after.columns != before.columns) {
    options.push_back("--columns '" + check::format_columns(after.columns) + "'");
  }
  if (after.unit && after.unit != before.unit) {
    options.push_back(std::string("--units ") + unit_word(*after.unit));
  }
  if (after.sequence != before.sequence) options.push_back("--sequence " + after.sequence);
  if (after.inverse && !before.inverse) options.emplace_back("--inverse");
  if (after.rates_in_space != before.rates_in_space) {
    options.push_back(after.rates_in_space ? "--rates space" : "--rates body");
  }
  return joined(options, " ");
}

bool is_foreign(const Judgement& judgement) { return !judgement.misfit.fits(); }

std::string verdict(const CheckedFile& file) {
  const Judgement& judgement = file.judgement;
  if (judgement.rows == 1) return "cannot be judged: one row tells nothing of a motion";
  if (begins_otherwise(judgement)) return beginning_text(judgement);
  if (judgement.reference.body.omega().norm() == 0) {
    return judgement.within_digits ? "cannot be faulted: the body is at rest, and stays so"
                                   : "does not follow the motion of a free body: it is at rest at "
                                     "first and turns later, by up to " +
                                         sizes_text(judgement);
  }
  if (is_foreign(judgement)) return foreign_text(file);
  if (is_no_rotation(judgement) && !judgement.attitude_contradicts_rates) {
    return no_rotation_text(judgement) +
           (judgement.within_digits ? faultless_text(judgement) : error_text(judgement));
  }
  if (judgement.within_digits) return "cannot be faulted: " + faultless_text(judgement);
  if (judgement.attitude_contradicts_rates) {
    const std::string of_rates = rates_within_digits(judgement)
                                     ? "the rates cannot be faulted: " + faultless_text(judgement)
                                     : "the rates are " + error_text(judgement);
    return contradiction_text(judgement) + "; " + of_rates;
  }
  return error_text(judgement);
}

}  // namespace twrench::app

#include <nlohmann/json.hpp>

#include "base/enumeration.h"
#include "base/words.h"
#include "check/report/report.h"
#include "recording/conventions/convention.h"

namespace twrench::check {
namespace {

using Json = nlohmann::ordered_json;

Json nullable(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json vector_json(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

Json size_json(const Judgement& judgement, const std::optional<ErrorSize>& size, double factor,
               const char* unit) {
  if (!size) return nullptr;
  return {{"unit", unit},
          {"max_error", size->max * factor},
          {"max_error_at", clock_time(judgement, size->at)},
          {"rms_error", size->rms * factor}};
}

Json flips_json(const Judgement& judgement) {
  const auto time = [&](const std::optional<double>& t) {
    return t ? Json(clock_time(judgement, *t)) : Json(nullptr);
  };
  Json list = Json::array();
  for (const Flip& flip : judgement.flips) {
    list.push_back({{"t", time(flip.found)}, {"exact", time(flip.exact)}});
  }
  return list;
}

Json value_json(const recording::FieldValue& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag;
  if (const auto* columns = std::get_if<std::map<std::string, std::string>>(&value))
    return *columns;
  if (const auto* q = std::get_if<Eigen::Quaterniond>(&value)) {
    return {q->w(), q->x(), q->y(), q->z()};
  }
  const auto* word = std::get_if<std::string>(&value);
  return word == nullptr || word->empty() ? Json(nullptr) : Json(*word);
}

Json convention_json(const recording::Convention& convention) {
  Json json;
  for (const recording::Field& field : recording::convention_fields()) {
    json[field.name] = value_json(field.value(convention));
  }
  return json;
}

Json fit_json(const Judgement& judgement, double factor) {
  if (!judgement.fit) return nullptr;
  const Fit& fit = *judgement.fit;
  Json covariance = Json::array();
  for (int i = 0; i < 3; ++i) {
    covariance.push_back(vector_json(fit.omega_covariance.row(i) * (factor * factor)));
  }
  const auto scaled = [](const std::optional<double>& value, double by) {
    return value ? Json(*value * by) : Json(nullptr);
  };
  return {{"rows", fit.rows},
          {"omega_deviation", vector_json(fit.omega_deviation * factor)},
          {"omega_covariance", covariance},
          {"frame_deviation",
           fit.frame_deviation ? vector_json(*fit.frame_deviation * degrees(1)) : Json(nullptr)},
          {"rate_residual", scaled(fit.rate_residual, factor)},
          {"attitude_residual", scaled(fit.attitude_residual, degrees(1))}};
}

Json phase_json(const Judgement& judgement, double factor) {
  if (!judgement.parts) return nullptr;
  const ErrorParts& parts = *judgement.parts;
  return {{"delay", parts.delay},
          {"delay_at", clock_time(judgement, parts.delay_at)},
          {"delay_at_end", parts.delay_at_end},
          {"rate_error", parts.phase_rate * factor},
          {"angle_about_momentum",
           judgement.has_attitude ? Json(degrees(parts.angle_about_l)) : Json(nullptr)}};
}

Json amplitude_json(const Judgement& judgement, double factor) {
  Json amplitude{{"energy_error", judgement.energy_error},
                 {"momentum_error", nullable(judgement.momentum_error)},
                 {"rate_error", nullptr},
                 {"angle_across_momentum", nullptr}};
  if (!judgement.parts) return amplitude;
  amplitude["rate_error"] = judgement.parts->amplitude_rate * factor;
  if (judgement.has_attitude) {
    amplitude["angle_across_momentum"] = degrees(judgement.parts->tilt);
  }
  return amplitude;
}

Json conditioning_json(const Judgement& judgement, double factor) {
  const LastDigits& digits = judgement.digits;
  const auto of_rates = [&](double value) {
    return judgement.has_rates ? Json(value * factor) : Json(nullptr);
  };
  const auto of_attitude = [&](double value) {
    return judgement.has_attitude ? Json(degrees(value)) : Json(nullptr);
  };
  return {{"rate_growth", judgement.growth.rates},
          {"attitude_growth", judgement.growth.attitude},
          {"rate_digit", of_rates(digits.rate)},
          {"rate_digit_printed", of_rates(digits.printed_rate)},
          {"attitude_digit", of_attitude(digits.attitude)},
          {"attitude_digit_printed", of_attitude(digits.printed_attitude)},
          {"time_digit", digits.time.at(judgement.duration)},
          {"rate_limit", of_rates(judgement.rate_limit)},
          {"attitude_limit", of_attitude(judgement.attitude_limit)},
          {"within_digits", judgement.within_digits}};
}

Json consistency_json(const Judgement& judgement) {
  if (!judgement.has_rates || !judgement.has_attitude) return nullptr;
  return {{"fit_each_other", !judgement.attitude_contradicts_rates},
          {"frame_rate", vector_json(judgement.frame_turn.rate * degrees(1))},
          {"explained_by_frame_rate", judgement.frame_turn.share}};
}

Json alternative_json(const CheckedFile& file, const Reading& reading) {
  const recording::Convention& before = file.judgement.convention;
  return {{"options", changing_arguments(before, reading.convention)},
          {"without_inverse", before.inverse && !reading.convention.inverse},
          {"read_as", convention_json(reading.convention)},
          {"misfit", nullable(reading.misfit.worst())}};
}

Json alternatives_json(const CheckedFile& file) {
  Json list = Json::array();
  for (const Reading& reading : file.alternatives.fitting) {
    list.push_back(alternative_json(file, reading));
  }
  return list;
}

Json nearest_json(const CheckedFile& file) {
  const auto& nearest = file.alternatives.nearest;
  return nearest ? alternative_json(file, *nearest) : Json(nullptr);
}

/// In axes of the body; only its ratios are determined.
Json inertia_json(const WrongLaws& laws) {
  const auto moments = std::ranges::find(laws.of_rates, Mistake::moments, &Explanation::mistake);
  if (moments == laws.of_rates.end()) return nullptr;
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i) rows.push_back(vector_json(moments->law.inertia.row(i)));
  return rows;
}

Json mistakes_json(const WrongLaws& laws) {
  Json list = Json::array();
  const auto add = [&list](const std::vector<Explanation>& explanations) {
    for (const Explanation& one : explanations) {
      list.push_back(
          {{"mistake", enumerator_name(one.mistake)},
           {"values", std::vector<double>(one.value.begin(), one.value.end())},
           {"deviations", std::vector<double>(one.deviation.begin(), one.deviation.end())},
           {"misfit", one.miss}});
    }
  };
  add(laws.of_rates);
  add(laws.of_attitude);
  return list;
}

Json noise_json(const Judgement& judgement, double factor) {
  return {{"rates", judgement.has_rates ? Json(judgement.noise.rate * factor) : Json(nullptr)},
          {"attitude",
           judgement.has_attitude ? Json(degrees(judgement.noise.attitude)) : Json(nullptr)}};
}

Json precision_json(const Judgement& judgement) {
  return {{"times", precision_text(judgement.digits.time)},
          {"rates",
           judgement.has_rates ? Json(precision_text(judgement.rate_resolution)) : Json(nullptr)},
          {"attitude", judgement.has_attitude ? Json(precision_text(judgement.attitude_resolution))
                                              : Json(nullptr)}};
}

Json bounds_json(const CheckedFile& file) {
  Json list = Json::array();
  for (const CheckBound& bound : file.bounds) {
    list.push_back({{"option", argument(bound.argument)},
                    {"unit", bound.unit.empty() ? Json(nullptr) : Json(bound.unit)},
                    {"most", bound.most},
                    {"value", bound.value},
                    {"exceeded", bound.is_exceeded()}});
  }
  return list;
}

Json matrix_json(const Eigen::Matrix3d& matrix) {
  return {vector_json(matrix.row(0)), vector_json(matrix.row(1)), vector_json(matrix.row(2))};
}

/// The inertia that was fitted: in units of its least moment, about the file's axes.
Json fitted_inertia_json(const CheckedFile& file) {
  if (!file.inertia) return nullptr;
  return {{"moments", vector_json(file.inertia->moments)},
          {"deviations", vector_json(file.inertia->deviation)},
          {"axes", matrix_json(file.inertia->axes.transpose())},
          {"matrix", matrix_json(file.inertia->inertia)}};
}

Json file_json(const CheckedFile& file) {
  const Judgement& judgement = file.judgement;
  const RateScale unit = rate_scale(judgement);
  const Verdict found = verdict(file);
  const double speed = judgement.reference.body.omega().norm();
  return {{"file", file.name},
          {"rows", judgement.rows},
          {"first_time", judgement.first_time},
          {"last_time", clock_time(judgement, judgement.duration)},
          {"step", file.step},
          {"read_as", convention_json(judgement.convention)},
          {"unread", file.unread},
          {"left_out", file.left_out},
          {"omega", vector_json(judgement.reference.body.omega() * unit.per_radian)},
          {"omega_at", clock_time(judgement, judgement.reference.start)},
          {"rates", size_json(judgement, judgement.rates, unit.per_radian, unit.symbol)},
          {"attitude", size_json(judgement, judgement.attitude, degrees(1), "deg")},
          {"energy_drift", judgement.energy_drift},
          {"momentum_drift", nullable(judgement.momentum_drift)},
          {"momentum_direction_drift",
           judgement.direction_drift ? Json(degrees(*judgement.direction_drift)) : Json(nullptr)},
          {"orthogonality_error", nullable(judgement.orthogonality_error)},
          {"quaternion_length", judgement.quaternion_length},
          {"flips", flips_json(judgement)},
          {"condition",
           judgement.has_rates ? judgement.growth.rates : judgement.growth.attitude * speed},
          {"conditioning", conditioning_json(judgement, unit.per_radian)},
          {"phase", phase_json(judgement, unit.per_radian)},
          {"amplitude", amplitude_json(judgement, unit.per_radian)},
          {"consistency", consistency_json(judgement)},
          {"fit", fit_json(judgement, unit.per_radian)},
          {"inertia", fitted_inertia_json(file)},
          {"precision", precision_json(judgement)},
          {"noise", noise_json(judgement, unit.per_radian)},
          {"follows_the_motion", !is_foreign(judgement)},
          {"alternatives", alternatives_json(file)},
          {"nearest", nearest_json(file)},
          {"mistakes", mistakes_json(file.alternatives.laws)},
          {"other_inertia", inertia_json(file.alternatives.laws)},
          {"bounds", bounds_json(file)},
          {"finding", enumerator_name(found.finding)},
          {"passes", passes(file)},
          {"verdict", found.text}};
}

/// Words the arguments in all texts.
void word_arguments(Json& json, const ArgumentWording& wording) {
  if (json.is_string()) json = with_arguments(json.get_ref<const std::string&>(), wording);
  if (!json.is_structured()) return;
  for (Json& element : json) word_arguments(element, wording);
}

}  // namespace

std::string check_json(const CheckResult& result, const ArgumentWording& wording) {
  Json document;
  if (result.files.size() == 1) {
    document = file_json(result.files.front());
  } else {
    document["files"] = Json::array();
    for (const CheckedFile& file : result.files) document["files"].push_back(file_json(file));
    const CheckOrders& orders = result.orders;
    document["order"] = {
        {"rates", nullable(orders.rates)},
        {"attitude", nullable(orders.attitude)},
        {"why_not", orders.why_not.empty() ? Json(nullptr) : Json(orders.why_not)}};
  }
  word_arguments(document, wording);
  return document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace twrench::check

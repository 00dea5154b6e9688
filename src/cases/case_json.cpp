#include "cases/case_json.h"

#include <nlohmann/json.hpp>

#include "base/enumeration.h"
#include "cases/solution.h"

namespace twrench::cases {
namespace {

using Json = nlohmann::ordered_json;

Json vector_json(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

Json quaternion_json(const Eigen::Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }

Json published_json(const Published& published, const State& exact) {
  const std::vector<double> components = exact_components(published, exact);
  std::vector<double> differences;
  for (std::size_t i = 0; i < components.size(); ++i) {
    differences.push_back(published.values[i] - components[i]);
  }
  return {{"by", published.by},
          {"t", published.time},
          {"quantity", enumerator_name(published.quantity)},
          {"unit", published.unit},
          {"digits", published.digits},
          {"values", published.values},
          {"exact", components},
          {"difference", differences},
          {"right_to_its_digits", is_right_to_its_digits(published, exact)}};
}

Json state_json(const State& state) {
  return {{"t", state.t},
          {"omega", vector_json(state.omega)},
          {"quaternion", quaternion_json(state.quaternion)},
          {"energy", state.energy},
          {"momentum", vector_json(state.momentum)}};
}

}  // namespace

Json summary_json(const Case& problem) {
  return {{"name", problem.name},
          {"title", problem.title},
          {"source", problem.source},
          {"url", problem.url},
          {"inertia", vector_json(problem.moments)},
          {"inertia_unit", problem.inertia_unit},
          {"omega", vector_json(problem.omega)},
          {"attitude", problem.attitude ? quaternion_json(*problem.attitude) : Json(nullptr)},
          {"duration", problem.duration}};
}

Json case_json(const Case& problem) {
  const Solution solution(problem);
  Json document = summary_json(problem);
  document["note"] = problem.note;
  document["published"] = Json::array();
  for (const Published& published : problem.published) {
    document["published"].push_back(published_json(published, solution.at(published.time)));
  }
  document["exact"] = Json::array();
  for (const double t : times_of(problem)) document["exact"].push_back(state_json(solution.at(t)));
  return document;
}

}  // namespace twrench::cases

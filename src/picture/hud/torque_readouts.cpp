#include "picture/hud/torque_readouts.h"

#include <fmt/format.h>

#include <numeric>

#include "picture/hud/hud_text.h"
#include "timeline/tilting_torque.h"

namespace twrench::picture {
namespace {

std::string torque_text(double torque) {
  const double size = std::abs(torque);
  const std::string sign = torque < 0 ? "−" : "+";
  if (size == 0) return "0";
  if (size >= 1e5 || size < 1e-2) return sign + hud_text::error(size);
  return sign + fmt::format("{:.{}f}", size, size < 1 ? 2 : size < 100 ? 1 : 0);
}

/// Makes the text smaller, because four readouts must fit side by side in a narrow panel.
TextStyle smaller(TextStyle style) {
  constexpr double share = 0.86;
  style.sizes.readout *= share;
  style.sizes.caption *= share;
  return style;
}

}  // namespace

TorqueReadouts::TorqueReadouts(const scene::Scene& scene,
                               const std::vector<timeline::Solution>& solutions,
                               const Layout& layout, const TextStyle& style)
    : block_(smaller(style), *layout.torques) {
  const timeline::TiltingTorque torque(scene, solutions[0].body);
  const std::string widest = "+8888";
  std::vector<Readout> row;
  for (const scene::PartGroup& group : scene::part_groups(scene.body)) {
    const std::string caption = row.empty() ? "torque, dyn cm: " : "";
    row.push_back(
        {caption + group.name, widest, [torque, i = row.size()](const timeline::FrameState& state) {
           return torque_text(torque.on_groups(state.solutions[0].sample)[i]);
         }});
  }
  row.push_back({"together", widest, [torque](const timeline::FrameState& state) {
                   const auto all = torque.on_groups(state.solutions[0].sample);
                   return torque_text(std::accumulate(all.begin(), all.end(), 0.0));
                 }});
  block_.add_readouts(row);
  block_.finish({0, 0, scene.film.width, scene.film.height});
}

std::vector<Layer> TorqueReadouts::draw(const timeline::FrameState& state) {
  std::vector<Layer> layers;
  if (!block_.is_empty()) layers.push_back(block_.draw(state));
  return layers;
}

}  // namespace twrench::picture

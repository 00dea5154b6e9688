#include "picture/hud/hud.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/time_unit.h"
#include "canvas/typesetting.h"
#include "picture/hud/captions.h"
#include "picture/hud/hud_text.h"
#include "picture/views/inset_views.h"
#include "scene/phrase.h"
#include "scene/shown_recording.h"

namespace twrench::picture {
namespace {

using scene::Phrase;

/// The common settings of the readouts of a video.
class Figures {
 public:
  Figures(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions, bool compact)
      : language_(scene.language),
        longest_(scene.motion.duration),
        resolution_(scene.film.speed / scene.film.fps),
        unit_(time_unit(longest_)),
        compact_(compact),
        recording_(scene.motion.recording) {
    for (const timeline::Solution& solution : solutions)
      flips_ = std::max(flips_, solution.flip_times.size());
  }

  Readout time() const {
    const bool has_gaps = recording_ && recording_->motion.has_gaps();
    const std::string gap = has_gaps ? phrase({" (no data)", " (ingen data)"}) : "";
    return {phrase({"time", "tid"}), text(longest_) + gap,
            [gap, has_gaps, self = *this](const timeline::FrameState& m) {
              const double t = m.solutions[0].sample.t;
              return self.text(t) + (has_gaps && self.recording_->motion.is_in_gap(t) ? gap : "");
            }};
  }
  Readout energy_drift(std::size_t solution) const {
    return {phrase(compact_ ? Phrase("drift", "drift") : Phrase("energy drift", "energidrift")),
            "+8.8×10⁻¹⁴", [solution](const timeline::FrameState& m) {
              return hud_text::drift(m.solutions[solution].diagnostics.energy_drift);
            }};
  }
  Readout orthogonality(std::size_t solution) const {
    return {phrase({"off SO(3)", "utenfor SO(3)"}), "8.8×10⁻¹⁴",
            [solution](const timeline::FrameState& m) {
              return hud_text::error(m.solutions[solution].diagnostics.orthogonality_error);
            }};
  }
  /// The angle between the first motion, which is recorded, and another.
  Readout angle(std::size_t solution) const {
    return {phrase({"from recorded", "fra målt"}), "180.0°",
            [solution](const timeline::FrameState& m) {
              return hud_text::degrees(m.solutions[0].sample, m.solutions[solution].sample);
            }};
  }
  Readout flips(std::size_t solution) const {
    return {phrase({"flips", "vendinger"}), fmt::format("{}", flips_),
            [solution](const timeline::FrameState& m) {
              return fmt::format("{}", m.solutions[solution].flips);
            }};
  }
  Readout next_flip(std::size_t solution) const {
    // One digit more than the time, so that it is not the time before the flip has been counted.
    const auto text = [resolution = resolution_ / 10, unit = unit_](double t) {
      return hud_text::time(t, resolution, unit);
    };
    return {phrase({"next flip", "neste vending"}), text(longest_),
            [solution, text, self = *this](const timeline::FrameState& m) {
              const auto& next = m.solutions[solution].next_flip;
              return next ? text(*next) : self.phrase({"none", "ingen"});
            }};
  }

 private:
  std::string phrase(const Phrase& phrase) const { return phrase.in(language_); }
  std::string text(double t) const { return hud_text::time(t, resolution_, unit_); }

  scene::Language language_;
  double longest_;
  double resolution_;
  TimeUnit unit_;
  bool compact_;
  std::shared_ptr<const scene::ShownRecording> recording_;
  std::size_t flips_ = 0;
};

/// Sets all text of a video.
class Typesetter {
 public:
  Typesetter(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
             const Layout& layout, const TextStyle& style)
      : scene_(scene), solutions_(solutions), layout_(layout), style_(style) {}

  std::vector<TextBlock> blocks() &&;

 private:
  bool shows(scene::Feature feature) const { return scene_.overlay.shows(feature); }
  bool compares() const { return solutions_.size() > 1; }
  void add_title();
  void add_readouts();
  void add_legend(std::size_t solution);
  void add_moment(TextBlock& block, std::size_t solution);
  void add_remark(TextBlock& block, std::size_t solution);
  void add_description();
  void add_heading(const image::Area& area, const std::string& text);

  const scene::Scene& scene_;
  const std::vector<timeline::Solution>& solutions_;
  const Layout& layout_;
  TextStyle style_;
  Figures figures_{scene_, solutions_, layout_.compact};
  std::vector<TextBlock> blocks_;
};

std::vector<TextBlock> Typesetter::blocks() && {
  if (layout_.title) add_title();
  if (layout_.readouts) add_readouts();
  for (std::size_t i = 0; i < layout_.legends.size(); ++i) add_legend(i);
  if (layout_.description) add_description();
  for (std::size_t i = 0; i < inset_views.size(); ++i) {
    const auto& pane = layout_.insets[i];
    if (!pane || !pane->heading) continue;
    add_heading(*pane->heading, inset_views[i].heading.in(scene_.language));
  }
  const image::Area picture{0, 0, scene_.film.width, scene_.film.height};
  for (TextBlock& block : blocks_) block.finish(picture);
  return std::move(blocks_);
}

void Typesetter::add_title() {
  TextBlock& block = blocks_.emplace_back(style_, *layout_.title);
  if (shows(scene::Feature::hud)) {
    const std::string& title = scene_.shown_title();
    canvas::require_characters(style_.typeface.strong, title, "title");
    if (compares()) block.add_corner(figures_.time());
    block.add_title(title, style_.typeface.strong, layout_.text.title, style_.colors.text);
  }
  if (shows(scene::Feature::method) && !compares()) {
    block.add_line(hud_text::method(solutions_[0], scene_.language), style_.typeface.regular,
                   layout_.text.caption, style_.colors.dim);
  }
}

void Typesetter::add_readouts() {
  TextBlock& block = blocks_.emplace_back(style_, *layout_.readouts);
  add_remark(block, 0);
  const bool hud = shows(scene::Feature::hud);
  std::vector<Readout> row;
  if (hud) row.push_back(figures_.time());
  if (shows(scene::Feature::drift)) row.push_back(figures_.energy_drift(0));
  if (hud && solutions_[0].turns_over()) {
    row.push_back(figures_.flips(0));
    row.push_back(figures_.next_flip(0));
  }
  block.add_readouts(row);
}

void Typesetter::add_legend(std::size_t solution) {
  TextBlock& block = blocks_.emplace_back(style_, layout_.legends[solution]);
  const Color curve = solution_color(style_.colors, solution);
  const bool plotted = layout_.components || layout_.curve;
  block.add_line(solutions_[solution].name, style_.typeface.strong, 0.85 * layout_.text.title,
                 style_.colors.text, plotted ? &curve : nullptr);
  if (shows(scene::Feature::moments)) add_moment(block, solution);
  const motion::FreeBody& body = solutions_[solution].body;
  std::vector<Readout> row;
  if (!scene_.overlay.compare.empty()) {
    const bool is_beside_recording = scene_.motion.recording && solution > 0;
    if (is_beside_recording) row.push_back(figures_.angle(solution));
    // An energy that is lost is no error.
    if (body.energy_loss() == 0) row.push_back(figures_.energy_drift(solution));
    if (!scene_.motion.recording) row.push_back(figures_.orthogonality(solution));
  }
  const bool has_flips = body.energy_loss() == 0;
  if (has_flips && (!row.empty() || shows(scene::Feature::hud))) {
    row.push_back(figures_.flips(solution));
  }
  if (!row.empty()) block.add_readouts(row);
  add_remark(block, solution);
}

/// Adds the moment of inertia about omega as a bar, in units of the body's greatest.
void Typesetter::add_moment(TextBlock& block, std::size_t solution) {
  const motion::FreeBody& body = solutions_[solution].body;
  if (body.omega().isZero(0.0)) return;
  const Eigen::Vector3d along = body.omega().normalized();
  const PrincipalFrame frame(body, style_.colors);
  Eigen::Index axis = 0;
  (frame.axes.transpose() * along).cwiseAbs().maxCoeff(&axis);
  block.add_bar(along.dot(body.inertia() * along) / body.principal().moments[2],
                frame.colors[static_cast<std::size_t>(axis)]);
}

/// Small pictures have no room for a remark.
void Typesetter::add_remark(TextBlock& block, std::size_t solution) {
  if (layout_.compact || !shows(scene::Feature::hud)) return;
  block.add_remark(
      captions::longest_remark(scene_.language),
      [solution, remarks = captions::Remarks(solutions_[solution], scene_.language)](
          const timeline::FrameState& state) { return remarks.at(state.solutions[solution]); });
}

void Typesetter::add_description() {
  TextBlock& block = blocks_.emplace_back(style_, *layout_.description);
  const timeline::Solution& solution = solutions_[0];
  const InsetView& view = inset_views[scene::inset_index(scene_.overlay.view)];
  const std::string text =
      view.description(solution, PrincipalFrame(solution.body, style_.colors), scene_.language);
  block.add_paragraph(text, style_.typeface.regular, layout_.text.readout, style_.colors.dim);
}

void Typesetter::add_heading(const image::Area& area, const std::string& text) {
  TextBlock& block = blocks_.emplace_back(style_, area);
  block.add_line(text, style_.typeface.regular, layout_.text.caption, style_.colors.text);
}

}  // namespace

bool needs_panels(const scene::Look& look) {
  return look.transparent || look.background.has_value();
}

Color solution_color(const OverlayColors& colors, std::size_t solution) {
  const std::array inks{colors.axis[0], colors.axis[2], colors.axis[1], colors.omega};
  return inks.at(solution);
}

Hud::Hud(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
         const Layout& layout, const canvas::Typeface& typeface, const OverlayColors& colors)
    : blocks_(Typesetter(scene, solutions, layout,
                         {typeface, colors, layout.text, layout.compact, needs_panels(scene.look)})
                  .blocks()) {}

std::vector<Layer> Hud::draw(const timeline::FrameState& state) {
  std::vector<Layer> layers;
  for (const TextBlock& block : blocks_) {
    if (!block.is_empty()) layers.push_back(block.draw(state));
  }
  return layers;
}

std::vector<image::Area> Hud::extents() const {
  std::vector<image::Area> extents;
  for (const TextBlock& block : blocks_) extents.push_back(block.extent());
  return extents;
}

}  // namespace twrench::picture

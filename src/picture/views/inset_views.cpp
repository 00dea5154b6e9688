#include "picture/views/inset_views.h"

#include <algorithm>

#include "picture/views/momentum_view.h"
#include "picture/views/poinsot_view.h"

namespace twrench::picture {
namespace {

template <typename Shown>
std::unique_ptr<SolutionView> make_inset(const scene::Scene& scene,
                                         const std::vector<timeline::Solution>& solutions,
                                         const Layout::Pane& pane) {
  return std::make_unique<Shown>(scene, solutions, 0, pane);
}

template <typename Shown>
constexpr InsetView inset_row(scene::View view) {
  return {view, Shown::heading, Shown::description, make_inset<Shown>};
}

}  // namespace

constexpr std::array<InsetView, scene::insets.size()> inset_views{
    inset_row<MomentumView>(scene::View::momentum), inset_row<PoinsotView>(scene::View::poinsot)};
static_assert(std::ranges::equal(inset_views, scene::insets, {}, &InsetView::view,
                                 &scene::Inset::view));

}  // namespace twrench::picture

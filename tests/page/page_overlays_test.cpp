// "Add an overlay" of CONTRIBUTING.md, on the page: every feature that the view of the body draws
// can be chosen there, and has a name in each language.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/enumeration.h"
#include "page_views.h"

namespace twrench::page {
namespace {

std::string web_file(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream(TWRENCH_TESTS_DIR "/../web/" + name).rdbuf();
  return text.str();
}

/// The features that users of the page can choose.
std::set<std::string> offered() {
  const std::string state = web_file("app/state.js");
  std::smatch list;
  if (!std::regex_search(state, list, std::regex(R"(features = \[([^\]]*)\])"))) return {};
  const std::string names = list[1];
  std::set<std::string> features;
  const std::regex name("'([a-z]+)'");
  for (std::sregex_iterator found(names.begin(), names.end(), name), end; found != end; ++found) {
    features.insert((*found)[1]);
  }
  return features;
}

/// The numbers of vertices and labels that the view of the body draws for the features.
std::vector<std::size_t> drawn_for(const std::set<scene::Feature>& features) {
  const Motion motion({Eigen::Vector3d(3, 4, 5).asDiagonal(), {0.1, 1, 0.2}});
  Settings settings;
  settings.width = 640;
  settings.height = 360;
  settings.interval = 0.01;
  settings.trail_length = 2;
  settings.trail_x = 1;
  for (const scene::Feature feature : features) settings.show += 1U << static_cast<int>(feature);
  timeline::SolutionState instant{};
  instant.trail = motion.at(std::vector{0.0, 0.5, 1.0, 1.5, 2.0});
  instant.sample = instant.trail.back();
  timeline::FrameState state;
  state.solutions.push_back(std::move(instant));
  const picture::ViewContents& contents = body_contents(motion, settings, {0.3, 0.2, 1}, state);
  return {contents.opaque.vertices().size(), contents.translucent.vertices().size(),
          contents.labels.size()};
}

TEST(PageOverlays, AreThoseThatTheViewOfTheBodyDraws) {
  using scene::Feature;
  const std::set<std::string> features = offered();
  for (const Feature feature : enumerators<Feature>) {
    // The page has no legend for their colours.
    const std::set coloured{Feature::forces, Feature::torques, Feature::tip};
    if (coloured.contains(feature)) continue;
    // The page does not know the mass, which determines the size of the ellipsoid.
    if (feature == Feature::inertia) continue;
    const bool is_drawn = drawn_for({feature}) != drawn_for({}) ||
                          drawn_for({Feature::axes, feature}) != drawn_for({Feature::axes});
    if (!is_drawn) continue;
    EXPECT_THAT(features, testing::Contains(enumerator_name(feature))) << "in web/app/state.js";
  }
}

TEST(PageOverlays, HaveANameInEachLanguage) {
  ASSERT_GT(offered().size(), 5U);
  for (const std::string language : {"en", "nb"}) {
    const auto words = nlohmann::json::parse(web_file("words/" + language + ".json"));
    for (const std::string& feature : offered()) {
      EXPECT_TRUE(words.contains("feature_" + feature)) << feature << " in " << language;
    }
  }
}

}  // namespace
}  // namespace twrench::page

#include "picture/hud/torque_gauge.h"

#include <gtest/gtest.h>

#include <cmath>

#include "picture/look/force_style.h"
#include "picture/overlay_scene.h"

namespace twrench::picture {
namespace {

scene::Scene with_torques(int width, int height) {
  scene::Scene scene = film_of(width, height);
  scene.camera.frame = scene::Frame::rotating;
  scene.overlay.show = {scene::Feature::torques};
  return scene;
}

struct Gauge {
  explicit Gauge(const scene::Scene& scene, int frame = 0)
      : all(scene, frame),
        gauge(all.scene, all.timeline.solutions(), all.layout, all.typeface, all.colors),
        layers(gauge.draw(all.timeline.frame_state(0))) {}

  /// Returns the number of pixels of exactly this colour in the middle row of the bar.
  int width_of(const Color& color) const {
    const Layer& layer = layers.at(0);
    const int y = gauge.bar().y + gauge.bar().height / 2 - layer.y;
    int count = 0;
    for (int x = 0; x < layer.image.width; ++x) {
      const std::uint8_t* p =
          &layer.image.pixels[static_cast<std::size_t>(y) * layer.image.row_bytes() +
                              static_cast<std::size_t>(4 * x)];
      count += p[0] == color.red && p[1] == color.green && p[2] == color.blue ? 1 : 0;
    }
    return count;
  }

  OverlayScene all;
  TorqueGauge gauge;
  std::vector<Layer> layers;
};

TEST(TorqueGauge, HasBarsInProportionToTheTorques) {
  const Gauge gauge(with_torques(1920, 1080), 110);
  const motion::Sample sample = gauge.all.timeline.frame_state(0).solutions[0].sample;
  const timeline::TiltingTorque torque(gauge.all.scene, gauge.all.timeline.solutions()[0].body);
  const auto [further, back] = torque.sides(sample);
  const int marker = gauge.width_of(gauge.all.colors.text);
  EXPECT_GT(marker, 2);
  EXPECT_NEAR(gauge.width_of(color_of_back(gauge.all.colors)),
              gauge.gauge.place(0) - gauge.gauge.place(back), 3);
  // The marker, with its border, hides a part of the larger bar.
  EXPECT_NEAR(gauge.width_of(color_of_further(gauge.all.colors)),
              gauge.gauge.place(further) - gauge.gauge.place(0) - 2 * marker, 7);
}

TEST(TorqueGauge, MovesItsMarkerTowardsTheWinner) {
  const Gauge gauge(with_torques(1920, 1080));
  const double middle = gauge.gauge.place(0), left = gauge.gauge.place(-100),
               right = gauge.gauge.place(100);
  EXPECT_NEAR(middle, 0.5 * (left + right), 1e-9);
  EXPECT_LT(left, middle);
  EXPECT_LT(middle, right);
  EXPECT_GE(gauge.gauge.place(-1e9), gauge.all.layout.torques->x) << "stays in the gauge";
}

TEST(TorqueGauge, HasDigitsOfAFiftiethOfTheHeight) {
  for (const auto& [width, height] : {std::pair(1920, 1080), {3840, 2160}, {1280, 720}}) {
    const Gauge gauge(with_torques(width, height));
    const double size = torque_text_size(gauge.all.layout.text);
    EXPECT_GE(size * gauge.all.typeface.regular.cap_height(), 0.02 * height);
  }
}

TEST(TorqueGauge, HasRoomForTheNamesOfSeveralGroups) {
  for (const auto& [width, height] : {std::pair(1920, 1080), {1080, 1920}, {1280, 720}}) {
    const Gauge gauge(with_torques(width, height));
    const canvas::Line names = canvas::typeset(gauge.all.typeface.regular, "cross, light discs");
    EXPECT_LE(names.width, gauge.gauge.name_width()) << width;
  }
}

TEST(TorqueGauge, StatesTorquesWithTheDecimalsOfTheFilm) {
  const Gauge gauge(with_torques(1920, 1080));
  EXPECT_EQ(gauge.gauge.text(205.7), "+206");
  EXPECT_EQ(gauge.gauge.text(-129.8), "−130");
  EXPECT_EQ(gauge.gauge.text(1e-16), "0") << "no jitter";
  EXPECT_EQ(gauge.gauge.text(-0.3), "0");
  for (const double factor : {1e-6, 1e6}) {
    scene::Scene scene = with_torques(1920, 1080);
    scene.motion.omega *= factor;
    scene.motion.duration /= factor;
    scene.film.speed /= factor;
    scene.motion.control.step /= factor;
    const Gauge other(scene);
    const std::string text = other.gauge.text(205.7 * factor * factor);
    EXPECT_EQ(text.substr(0, 4), "+2.0") << text;
    EXPECT_LE(text.size(), 5U) << text;
  }
}

TEST(TorqueGauge, StaysInTheMiddleWithoutATorque) {
  for (const Eigen::Vector3d& omega : {Eigen::Vector3d(0, 0, 0), {1, 0, 0}, {0, 0, 1}}) {
    scene::Scene scene = with_torques(1920, 1080);
    scene.motion.omega = omega;
    const Gauge gauge(scene, 50);
    EXPECT_EQ(gauge.width_of(color_of_further(gauge.all.colors)), 0);
    EXPECT_EQ(gauge.width_of(color_of_back(gauge.all.colors)), 0);
    EXPECT_GT(gauge.width_of(gauge.all.colors.text), 2);
    EXPECT_EQ(gauge.gauge.place(1e-16), gauge.gauge.place(0));
  }
}

TEST(TorqueGauge, StaysInItsArea) {
  for (const auto& [width, height] :
       {std::pair(1920, 1080), {1080, 1920}, {640, 360}, {320, 180}}) {
    const scene::Scene scene = with_torques(width, height);
    if (!compute_layout(scene).torques) continue;
    const Gauge gauge(scene, 110);
    EXPECT_EQ(gauge.layers.at(0).area(), *gauge.all.layout.torques);
  }
}

}  // namespace
}  // namespace twrench::picture

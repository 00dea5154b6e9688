// Times the main functions of a render individually, at 1920x1080 unless the name says otherwise.
#include <benchmark/benchmark.h>
#include <twrench/math/so3.h>

#include "draw/pose_renderer.h"
#include "gl/backend.h"
#include "image/png.h"
#include "image/yuv.h"
#include "picture/look/background.h"

namespace twrench {
namespace {

scene::Scene full_scene() {
  scene::Scene scene = scene::load_scene("dzhanibekov");
  scene.film.width = 1920;
  scene.film.height = 1080;
  return scene;
}

gl::OpenedContext context() { return gl::open_context({}); }

/// A pose that varies from frame to frame and shows all sides.
Eigen::Matrix3d pose(int frame) {
  return so3::exp(Eigen::Vector3d(0.11 * frame, 0.05 * frame, 0.3));
}

const image::Image& frame() {
  static const image::Image image = [] {
    const auto opened = context();
    return draw::PoseRenderer(*opened.context, full_scene()).draw(pose(7));
  }();
  return image;
}

void Draw(benchmark::State& state) {
  const auto opened = context();
  scene::Scene scene = full_scene();
  scene.look.samples = static_cast<int>(state.range(0));
  draw::PoseRenderer renderer(*opened.context, scene);
  int i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(renderer.draw(pose(++i)).pixels.data());
}
BENCHMARK(Draw)
    ->ArgName("samples")
    ->Arg(1)
    ->Arg(4)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

void Open(benchmark::State& state) {
  for (auto _ : state) {
    const auto opened = context();
    draw::PoseRenderer renderer(*opened.context, full_scene());
    benchmark::DoNotOptimize(renderer.draw(pose(0)).pixels.data());
  }
}
BENCHMARK(Open)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

void Background(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(picture::background(full_scene().look, 1920, 1080).pixels.data());
}
BENCHMARK(Background)->Unit(benchmark::kMillisecond);

/// A square in the middle that covers the given fraction of the frame.
void ConvertToYuv(benchmark::State& state) {
  image::Yuv420 yuv(1920, 1080);
  const int percent = static_cast<int>(state.range(0));
  const int width = 192 * percent / 10;
  const image::Area area{(1920 - width) / 2, 0, width, 1080};
  for (auto _ : state) {
    yuv.update(frame(), area);
    benchmark::DoNotOptimize(yuv.bytes().data());
  }
}
BENCHMARK(ConvertToYuv)->ArgName("percent")->Arg(20)->Arg(100)->Unit(benchmark::kMillisecond);

void EncodePng(benchmark::State& state) {
  std::size_t bytes = 0;
  for (auto _ : state) bytes = image::encode_png(frame()).size();
  state.counters["kB"] = static_cast<double>(bytes) / 1e3;
}
BENCHMARK(EncodePng)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace twrench

// Time of one capture.
#include <benchmark/benchmark.h>

#include <mixed_palletizing/simulation/capture.hpp>

namespace {

using namespace mixed_palletizing::simulation;

Scene sixBoxes(bool all_effects) {
  Scene scene;
  for (int i = 0; i < 6; ++i) {
    SceneBox box;
    box.size_m = Eigen::Vector3d(0.20, 0.15, 0.08 + 0.02 * i);
    box.position_m = Eigen::Vector2d(-0.30 + 0.30 * (i % 3), i < 3 ? -0.22 : 0.22);
    box.yaw_rad = 0.3 * i;
    box.labels.push_back({});
    scene.boxes.push_back(box);
  }
  scene.camera.world_from_camera = lookAt({0.0, -0.9, 1.3}, {0.0, 0.0, 0.0});
  scene.noise.depth_stddev_at_1m_m = 0.0003;
  scene.noise.no_data_on_black = true;
  if (all_effects) {
    scene.camera.projector_m = Eigen::Vector3d(0.12, 0.0, 0.0);
    scene.noise.dropout_ratio = 0.01;
    scene.noise.flying_pixel_ratio = 0.3;
  }
  return scene;
}

/// 1920 x 1200, six boxes; arguments: threads, whether projector shadow, drop-outs and flying pixels are on.
void captureSixBoxes(benchmark::State& state) {
  const Scene scene = sixBoxes(state.range(1) != 0);
  std::uint64_t seed = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(capture(scene, ++seed, static_cast<int>(state.range(0))));
  }
}
BENCHMARK(captureSixBoxes)
    ->ArgNames({"threads", "all_effects"})
    ->ArgsProduct({{1, 2}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// The same with uneven boxes, thousands of triangles each, and all effects; argument: threads.
void captureSixUnevenBoxes(benchmark::State& state) {
  Scene scene = sixBoxes(true);
  for (SceneBox& box : scene.boxes) {
    box.shape.bulge_m = 0.006;
    box.shape.rounding_m = 0.006;
    box.shape.dents = {{{0.02, 0.02}, 0.03, 0.01}, {{-0.05, -0.04}, 0.02, 0.008}};
  }
  std::uint64_t seed = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(capture(scene, ++seed, static_cast<int>(state.range(0))));
  }
}
BENCHMARK(captureSixUnevenBoxes)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace

BENCHMARK_MAIN();

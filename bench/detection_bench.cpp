// Times of the detection beside the plain reading of the same cloud, PCL's conversion, PCL's clusters, and a
// literal rendering of the source thesis with PCL; and the memory of the detection beside the message.
#include <cmath>

#include <benchmark/benchmark.h>
#include <pcl_conversions/pcl_conversions.h>

#include <mixed_palletizing/adapters/cloud_message.hpp>
#include <mixed_palletizing/detection/base_frame.hpp>
#include <mixed_palletizing/detection/box_detector.hpp>
#include <mixed_palletizing/simulation/capture.hpp>
#include <mixed_palletizing/simulation/recipe.hpp>

#include "memory_meter.hpp"
#include "pcl_thesis.hpp"

namespace mixed_palletizing {
namespace {

/// One 1920 x 1200 capture of four separated boxes, as the driver's message.
struct Setup {
  sensor_msgs::PointCloud2Ptr message;
  geometry::CloudView view;
  geometry::Pose base_from_camera;
};

const Setup& setup() {
  static const Setup instance = [] {
    simulation::Recipe recipe;
    recipe.groups.front().count = {4, 4};
    recipe.scene.noise.depth_stddev_at_1m_m = 0.0002;
    recipe.scene.noise.no_data_on_black = true;
    const simulation::Scene scene = simulation::recipeScene(recipe, 7, 0);
    Setup made;
    std_msgs::Header header;
    header.frame_id = "camera";
    made.message = adapters::toMessage(simulation::capture(scene, 7, 2).cloud, header);
    made.view = *adapters::checkCloud(*made.message).view;
    made.base_from_camera =
        simulation::worldFromMarker(scene.marker).inverse() * scene.camera.world_from_camera;
    return made;
  }();
  return instance;
}

void readPass(benchmark::State& state) {
  const geometry::CloudView& view = setup().view;
  for (auto _ : state) {
    double sum = 0.0;
    for (int row = 0; row < view.height; ++row) {
      const std::uint8_t* p = view.at(row, 0) + view.z_offset;
      for (int col = 0; col < view.width; ++col, p += view.point_step) {
        const float z = geometry::CloudView::readFloat(p);
        if (!std::isnan(z)) sum += static_cast<double>(z);
      }
    }
    benchmark::DoNotOptimize(sum);
  }
}
BENCHMARK(readPass)->Unit(benchmark::kMillisecond);

void checkMessage(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(adapters::checkCloud(*setup().message).view.has_value());
}
BENCHMARK(checkMessage)->Unit(benchmark::kMillisecond);

void fromRosMessage(benchmark::State& state) {
  pcl::PointCloud<pcl::PointXYZRGB> cloud;
  for (auto _ : state) {
    pcl::fromROSMsg(*setup().message, cloud);
    benchmark::DoNotOptimize(cloud.points.data());
  }
}
BENCHMARK(fromRosMessage)->Unit(benchmark::kMillisecond);

void pclClusters(benchmark::State& state) {
  pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZRGB>);
  pcl::fromROSMsg(*setup().message, *cloud);
  bench::PclThesis thesis(setup().base_from_camera);
  thesis.transform(*cloud);
  for (auto _ : state) benchmark::DoNotOptimize(thesis.clusters().size());
}
BENCHMARK(pclClusters)->Unit(benchmark::kMillisecond);

void pclThesis(benchmark::State& state) {
  std::size_t boxes = 0;
  for (auto _ : state) {
    pcl::PointCloud<pcl::PointXYZRGB> cloud;
    pcl::fromROSMsg(*setup().message, cloud);
    bench::PclThesis thesis(setup().base_from_camera);
    thesis.transform(cloud);
    boxes = thesis.hulls(thesis.clusters());
  }
  state.counters["boxes"] = static_cast<double>(boxes);
}
BENCHMARK(pclThesis)->Unit(benchmark::kMillisecond);

void detect(benchmark::State& state, detection::Method method) {
  detection::DetectionOptions options;
  options.method = method;
  detection::BoxDetector detector(options);
  detection::Detections last;
  for (auto _ : state) {
    last = detector.detect(*adapters::checkCloud(*setup().message).view, setup().base_from_camera);
    benchmark::DoNotOptimize(last.boxes.data());
  }
  state.counters["boxes"] = static_cast<double>(last.boxes.size());
  for (const detection::StageTime& time : last.stage_times) state.counters[time.stage] = time.milliseconds;
}
BENCHMARK_CAPTURE(detect, best, detection::Method::kBest)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(detect, thesis, detection::Method::kThesis)->Unit(benchmark::kMillisecond);

/// Heap of a new detector over its first cloud (peak), and what a further cloud takes: its labels, and the rest.
void detectMemory(benchmark::State& state, detection::Method method) {
  constexpr double kMegabyte = 1e6;
  detection::DetectionOptions options;
  options.method = method;
  const detection::Detections before = detection::BoxDetector(options).detect(
      setup().view, setup().base_from_camera);  // what the process takes once is there from now on
  const double labels = static_cast<double>(before.labels.size() * sizeof(before.labels[0]));
  for (auto _ : state) {
    test::startMemoryUse();
    detection::BoxDetector detector(options);
    detector.detect(setup().view, setup().base_from_camera);
    const test::MemoryUse first = test::memoryUse();
    test::startMemoryUse();
    benchmark::DoNotOptimize(detector.detect(setup().view, setup().base_from_camera).boxes.size());
    const test::MemoryUse next = test::memoryUse();
    state.counters["message_MB"] = static_cast<double>(setup().message->data.size()) / kMegabyte;
    state.counters["peak_MB"] = static_cast<double>(first.peak_bytes) / kMegabyte;
    state.counters["labels_MB"] = labels / kMegabyte;
    state.counters["next_peak_MB"] = static_cast<double>(next.peak_bytes) / kMegabyte;
    state.counters["next_MB"] = static_cast<double>(next.bytes) / kMegabyte;
    state.counters["next_allocations"] = static_cast<double>(next.allocations);
  }
}
BENCHMARK_CAPTURE(detectMemory, best, detection::Method::kBest)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK_CAPTURE(detectMemory, thesis, detection::Method::kThesis)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

void findBaseFrame(benchmark::State& state) {
  for (auto _ : state) {
    const auto result = detection::findBaseFrame(setup().view, detection::BaseFrameSource::kMarker,
                                                 detection::DetectionOptions());
    benchmark::DoNotOptimize(result.frame.has_value());
  }
}
BENCHMARK(findBaseFrame)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mixed_palletizing

BENCHMARK_MAIN();

#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>

#include <mixed_palletizing/detection/base_frame.hpp>
#include <mixed_palletizing/detection/box_detector.hpp>
#include <mixed_palletizing/experiments/box_pairing.hpp>
#include <mixed_palletizing/experiments/scene_measurement.hpp>

namespace mixed_palletizing::experiments {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

geometry::Rectangle footprint(const detection::DetectedBox& box) {
  return {box.top_center.head<2>(), box.yaw_rad, box.size.head<2>()};
}

/// Base frame of the cloud; nothing when it was looked for in vain.
std::optional<geometry::Pose> findBase(const geometry::CloudView& cloud, const geometry::Pose& true_base,
                                       const MeasurementOptions& options, SceneRecord& record) {
  record.base_found = true;
  if (options.base == BaseSource::kTruth) return true_base;
  const auto start = Clock::now();
  const detection::BaseFrameResult result =
      detection::findBaseFrame(cloud, detection::BaseFrameSource::kMarker, options.detection);
  record.base_ms = millisecondsSince(start);
  if (!result.frame) {
    record.base_found = false;
    record.base_message = result.message;
    return std::nullopt;
  }
  record.base = baseFrameErrors(true_base, result.frame->base_from_camera);
  return result.frame->base_from_camera;
}

void compare(const simulation::Scene& scene, const geometry::Pose& true_base,
             const geometry::Pose& found_base, const detection::Detections& detections, SceneRecord& record) {
  std::vector<TrueBox> truth;
  for (const BoxRecord& box : record.boxes) truth.push_back(box.truth);
  const auto pairs = pairBoxes(truth, detections.boxes);
  std::vector<bool> used(detections.boxes.size(), false);
  const auto corners = [&](const detection::DetectedBox& box) {
    return projectedCorners(scene, found_base, footprint(box), box.top_center.z());
  };
  for (std::size_t i = 0; i < truth.size(); ++i) {
    record.found_corners_px.emplace_back();
    if (!pairs[i]) continue;
    used[*pairs[i]] = true;
    const detection::DetectedBox& box = detections.boxes[*pairs[i]];
    record.boxes[i].found = box;
    record.boxes[i].errors = boxErrors(truth[i], box, true_base, found_base);
    record.found_corners_px.back() = corners(box);
  }
  for (std::size_t i = 0; i < detections.boxes.size(); ++i) {
    if (used[i]) continue;
    record.invented.push_back(detections.boxes[i]);
    record.invented_corners_px.push_back(corners(detections.boxes[i]));
  }
  for (const detection::RejectedCluster& cluster : detections.rejected) {
    record.refusals.push_back(std::string(toString(cluster.reason)) + ": " + cluster.text);
  }
}

SceneRecord measure(const SceneSource& source, std::uint64_t index, const MeasurementOptions& options,
                    detection::BoxDetector& detector,
                    const std::function<void(const simulation::Capture&)>& look) {
  const simulation::Scene scene = source.scene(index);
  const simulation::Capture capture = simulation::capture(scene, source.noise_seed(index));
  if (look) look(capture);
  const geometry::Pose true_base = trueBaseFromCamera(scene);
  SceneRecord record;
  record.index = index;
  for (const TrueBox& truth : trueBoxes(scene, capture)) record.boxes.push_back({truth, std::nullopt, {}});
  const geometry::CloudView view = capture.cloud.view();
  const auto base = findBase(view, true_base, options, record);
  if (!base) return record;
  const auto start = Clock::now();
  const detection::Detections detections = detector.detect(view, *base);
  record.detect_ms = millisecondsSince(start);
  compare(scene, true_base, *base, detections, record);
  return record;
}

}  // namespace

SceneSource recipeSource(const simulation::Recipe& recipe, std::uint64_t seed) {
  return {[recipe, seed](std::uint64_t index) { return simulation::recipeScene(recipe, seed, index); },
          [seed](std::uint64_t index) { return simulation::recipeNoiseSeed(seed, index); }};
}

SceneRecord measureScene(const SceneSource& source, std::uint64_t index, const MeasurementOptions& options,
                         const std::function<void(const simulation::Capture&)>& look) {
  detection::BoxDetector detector(options.detection);
  return measure(source, index, options, detector, look);
}

std::vector<SceneRecord> measureScenes(const SceneSource& source, std::uint64_t first, std::uint64_t count,
                                       const MeasurementOptions& options, int threads,
                                       const std::function<void()>& done) {
  if (threads < 1) {
    throw std::invalid_argument("measureScenes: threads = " + std::to_string(threads) +
                                ", at least 1 needed");
  }
  std::vector<SceneRecord> records(count);
  std::atomic<std::uint64_t> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    try {
      detection::BoxDetector detector(options.detection);
      for (std::uint64_t i = next++; i < count; i = next++) {
        records[i] = measure(source, first + i, options, detector, nullptr);
        const std::lock_guard<std::mutex> lock(mutex);
        if (done) done();
      }
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex);
      if (!failure) failure = std::current_exception();
      next = count;
    }
  };
  std::vector<std::thread> workers;
  for (int i = 1; i < threads; ++i) workers.emplace_back(work);
  work();
  for (std::thread& worker : workers) worker.join();
  if (failure) std::rethrow_exception(failure);
  return records;
}

}  // namespace mixed_palletizing::experiments

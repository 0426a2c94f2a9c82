#include <cstring>
#include <thread>

#include <mixed_palletizing/detection/box_detector.hpp>
#include <mixed_palletizing/packing/order_packing.hpp>
#include <mixed_palletizing/planning/play_arrivals.hpp>
#include <mixed_palletizing/simulation/capture.hpp>

#include "../unit/planning/support.hpp"
#include "../unit/simulation/small_scenes.hpp"
#include "invariants.hpp"

namespace mixed_palletizing::torture {
namespace {

using planning::test::randomOrder;
using planning::test::shuffledItems;

constexpr int kCloudWidth = 160;

bool packsAlike(std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  const packing::Order order = randomOrder(rng);
  const std::vector<int> items = shuffledItems(order, rng);
  packing::PackOptions options;
  options.method = packing::PackMethod::kBrkga;
  options.key_genetic.population = 16;
  options.key_genetic.generations = 2;
  options.seed = seed;
  const auto sums = [&](int threads) {
    options.threads = threads;
    const packing::OrderPacking packing = packing::packOrder(order, items, options, [] { return false; });
    std::vector<packing::Placement> placements;
    for (const packing::PackedItem& item : packing.packed) placements.push_back(item.placement);
    return std::make_pair(placements, packing.unpacked);
  };
  return sums(1) == sums(2);
}

bool plansAlike(std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  const packing::Order order = randomOrder(rng);
  const std::vector<int> arrival = shuffledItems(order, rng);
  planning::PlayOptions options;
  options.planner.best.samples = 2;
  options.planner.best.candidates = 3;
  options.seed = seed;
  const auto play = [&](int threads) {
    options.planner.best.threads = threads;
    const planning::PlayResult result = planning::playArrivals(order, arrival, options);
    std::vector<packing::Placement> placements;
    for (const planning::PlayedPlacement& placed : result.placements) placements.push_back(placed.placement);
    return std::make_pair(placements, result.unpacked);
  };
  return play(1) == play(2);
}

bool sameBytes(const simulation::Capture& a, const simulation::Capture& b) {
  const std::size_t bytes = a.cloud.points.size() * sizeof(geometry::ColoredPoint);
  return a.cloud.points.size() == b.cloud.points.size() &&
         std::memcmp(a.cloud.points.data(), b.cloud.points.data(), bytes) == 0 && a.mask == b.mask &&
         a.top_visibility == b.top_visibility;
}

bool sameBoxes(const detection::Detections& a, const detection::Detections& b) {
  bool same =
      a.boxes.size() == b.boxes.size() && a.rejected.size() == b.rejected.size() && a.labels == b.labels;
  for (std::size_t i = 0; same && i < a.boxes.size(); ++i) {
    same = a.boxes[i].center == b.boxes[i].center && a.boxes[i].size == b.boxes[i].size &&
           a.boxes[i].yaw_rad == b.boxes[i].yaw_rad && a.boxes[i].flags == b.boxes[i].flags;
  }
  return same;
}

detection::Detections boxesOf(const simulation::Scene& scene, const simulation::Capture& capture) {
  detection::BoxDetector detector{detection::DetectionOptions()};
  return detector.detect(capture.cloud.view(), scene.camera.world_from_camera);
}

/// Empty, or what differs: the cloud of one thread and of two; the boxes of two detectors side by side and of one alone.
std::string captureFault(std::uint64_t seed) {
  simulation::Scene scene = simulation::smallScene(seed, kCloudWidth);
  scene.noise = {0.0005, true, 0.02, 0.4, 0.02};
  const simulation::Capture capture = simulation::capture(scene, seed, 1);
  if (!sameBytes(capture, simulation::capture(scene, seed, 2))) return "another cloud";
  const detection::Detections alone = boxesOf(scene, capture);
  detection::Detections first;
  detection::Detections second;
  std::thread other([&] { second = boxesOf(scene, capture); });
  first = boxesOf(scene, capture);
  other.join();
  return sameBoxes(alone, first) && sameBoxes(alone, second) ? "" : "other boxes";
}

std::string faultOf(std::uint64_t seed) {
  if (!packsAlike(seed)) return "another packing";
  if (!plansAlike(seed)) return "another plan";
  return captureFault(seed);
}

}  // namespace

Cases compareThreads(long seeds, std::uint64_t seed) {
  Cases cases;
  for (std::uint64_t s = seed; cases.tried < seeds; ++s) {
    const std::string fault = faultOf(s);
    cases.add(fault.empty() ? "" : "seed " + std::to_string(s) + ": " + fault);
  }
  return cases;
}

}  // namespace mixed_palletizing::torture

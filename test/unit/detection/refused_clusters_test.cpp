// Everything above the floor ends as a box or as a rejected cluster.
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include <gtest/gtest.h>

#include <mixed_palletizing/detection/box_detector.hpp>

#include "simulated_scenes.hpp"

namespace mixed_palletizing::detection {
namespace {

using simulation::Scene;
using simulation::SceneObject;

constexpr double kAboveFloor = 0.03;  // [m]
constexpr int kRoomySteps = 2;        // times the smallest cluster

double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Upright and lying cylinders and tilted blocks, some of which stand against a box or lie on one.
void addObjects(Scene& scene, std::mt19937_64& random) {
  const int count = std::uniform_int_distribution<int>(1, 3)(random);
  for (int i = 0; i < count; ++i) {
    SceneObject object;
    const double size = uniform(random, 0.04, 0.09);
    const bool round = uniform(random, 0.0, 1.0) < 0.7;
    object.mesh = std::make_shared<simulation::TriangleMesh>(
        round ? simulation::cylinderMesh(size, uniform(random, 0.06, 0.2))
              : simulation::cuboidMesh({size, 1.5 * size, 0.1}));
    Eigen::Vector3d place(uniform(random, -0.25, 0.25), uniform(random, -0.2, 0.2), 0.0);
    if (!scene.boxes.empty() && uniform(random, 0.0, 1.0) < 0.5) {
      const simulation::SceneBox& box = scene.boxes[random() % scene.boxes.size()];
      const double beside = 0.5 * box.size_m.x() + size + 0.002;
      const Eigen::Vector2d axis(std::cos(box.yaw_rad), std::sin(box.yaw_rad));
      place.head<2>() = box.position_m + (uniform(random, 0.0, 1.0) < 0.7 ? beside : 0.0) * axis;
      if ((place.head<2>() - box.position_m).norm() < 1e-6) place.z() = box.size_m.z();
    }
    const bool lies = uniform(random, 0.0, 1.0) < 0.3;
    if (lies) place.z() += size;
    object.world_from_object = simulation::poseFromRollPitchYaw(
        place, {lies ? M_PI / 2 : 0.0, round ? 0.0 : 0.4, uniform(random, -M_PI, M_PI)});
    scene.objects.push_back(object);
  }
}

/// A connected set of points above the floor that no box has.
struct Rest {
  int points = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Vector3d centroid() const { return sum / points; }
};

std::vector<Rest> restsOf(const geometry::CloudView& view, const geometry::Pose& base_from_camera,
                          const Detections& found) {
  const auto at = [&](int row, int col) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(view.width) +
           static_cast<std::size_t>(col);
  };
  std::vector<char> open(view.size(), 0);
  for (int row = 0; row < view.height; ++row) {
    for (int col = 0; col < view.width; ++col) {
      const Eigen::Vector3d p = base_from_camera * view.point(row, col).cast<double>();
      open[at(row, col)] = p.z() > kAboveFloor && found.labels[at(row, col)] == 0 ? 1 : 0;
    }
  }
  std::vector<Rest> rests;
  std::vector<std::pair<int, int>> waiting;
  for (int row = 0; row < view.height; ++row) {
    for (int col = 0; col < view.width; ++col) {
      if (open[at(row, col)] == 0) continue;
      rests.emplace_back();
      waiting.assign(1, {row, col});
      open[at(row, col)] = 0;
      while (!waiting.empty()) {
        const auto [r, c] = waiting.back();
        waiting.pop_back();
        ++rests.back().points;
        rests.back().sum += base_from_camera * view.point(r, c).cast<double>();
        for (const auto& [down, right] : {std::make_pair(0, 1), {0, -1}, {1, 0}, {-1, 0}}) {
          const int i = r + down;
          const int k = c + right;
          if (i < 0 || k < 0 || i >= view.height || k >= view.width || open[at(i, k)] == 0) continue;
          open[at(i, k)] = 0;
          waiting.emplace_back(i, k);
        }
      }
    }
  }
  return rests;
}

bool isListed(const Detections& found, const Eigen::Vector3d& place) {
  return std::any_of(found.rejected.begin(), found.rejected.end(), [&](const RejectedCluster& cluster) {
    return !cluster.text.empty() &&
           ((place - cluster.centroid).cwiseAbs().array() < cluster.extent.array() + 0.01).all();
  });
}

TEST(RefusedClusters, everyClusterIsABoxOrHasAReason) {
  int rests_seen = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    auto recipe = test::sceneRecipe(0.0002, 800, 500);
    recipe.groups.front().count = {1, 2};
    Scene scene = simulation::recipeScene(recipe, seed, 0);
    addObjects(scene, random);
    const auto capture = simulation::capture(scene, seed);
    const DetectionOptions options;
    BoxDetector detector(options);
    const geometry::Pose base_from_camera = test::trueBaseFromCamera(scene);
    const Detections found = detector.detect(capture.cloud.view(), base_from_camera);
    for (const Rest& rest : restsOf(capture.cloud.view(), base_from_camera, found)) {
      if (rest.points < kRoomySteps * options.cluster.min_points) continue;
      ++rests_seen;
      EXPECT_TRUE(isListed(found, rest.centroid()))
          << rest.points << " points around " << rest.centroid().transpose();
    }
  }
  EXPECT_GT(rests_seen, 10);
}

}  // namespace
}  // namespace mixed_palletizing::detection

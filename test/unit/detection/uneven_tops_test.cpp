// Tops that are no planes: dents, bulges, rounded edges, flaps.
#include <random>

#include <gtest/gtest.h>

#include <mixed_palletizing/detection/box_detector.hpp>
#include <mixed_palletizing/simulation/scene_box.hpp>

#include "simulated_scenes.hpp"

namespace mixed_palletizing::detection {
namespace {

using simulation::Scene;
using simulation::SceneBox;

using Random = std::mt19937_64;

double between(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// A random scene of sharp boxes, each changed by `shape`.
template <typename Shape>
Scene shapedScene(std::uint64_t seed, Shape shape) {
  Scene scene = simulation::recipeScene(test::sceneRecipe(0.0002, 1280, 800), seed, 0);
  Random random(seed);
  for (SceneBox& box : scene.boxes) shape(box, random);
  return scene;
}

/// Mean of the top over its nominal plane, within its rounded edges.
double meanOffset(const SceneBox& box) {
  constexpr int kSteps = 40;
  const Eigen::Vector2d half = 0.5 * box.size_m.head<2>().array() - box.shape.rounding_m;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    for (int k = 0; k < kSteps; ++k) {
      const Eigen::Array2d at((2.0 * i + 1.0) / kSteps - 1.0, (2.0 * k + 1.0) / kSteps - 1.0);
      sum += simulation::topOffset(box, (half.array() * at).matrix());
    }
  }
  return sum / (kSteps * kSteps);
}

/// Every box is found with both sides within `side_m` and the mean height of its top, and nothing else is.
void expectFound(const Scene& scene, std::uint64_t seed, double side_m, double height_m) {
  const auto capture = simulation::capture(scene, seed);
  BoxDetector detector{DetectionOptions()};
  const Detections found = detector.detect(capture.cloud.view(), test::trueBaseFromCamera(scene));
  EXPECT_EQ(found.boxes.size(), scene.boxes.size()) << "seed " << seed;
  const auto truths = test::trueBoxes(scene);
  for (std::size_t i = 0; i < truths.size(); ++i) {
    if (capture.top_visibility[i] < 0.98) continue;
    const DetectedBox* box = test::nearest(found, truths[i]);
    ASSERT_NE(box, nullptr) << "seed " << seed << ", box " << i;
    EXPECT_LT((box->size - truths[i].size).head<2>().cwiseAbs().maxCoeff(), side_m)
        << "seed " << seed << ", box " << i;
    EXPECT_NEAR(box->size.z(), truths[i].size.z() + meanOffset(scene.boxes[i]), height_m)
        << "seed " << seed << ", box " << i;
  }
}

TEST(UnevenTops, aDentIsAPartOfItsTop) {
  for (std::uint64_t seed = 700; seed < 706; ++seed) {
    const Scene scene = shapedScene(seed, [](SceneBox& box, Random& random) {
      const Eigen::Vector2d half = 0.5 * box.size_m.head<2>();
      for (int i = 0; i < 2; ++i) {
        simulation::BoxDent dent;
        dent.center_m =
            half.cwiseProduct(Eigen::Vector2d(between(random, -0.9, 0.9), between(random, -0.9, 0.9)));
        dent.radius_m = between(random, 0.01, 0.04);
        dent.depth_m = between(random, 0.003, 0.012);
        box.shape.dents.push_back(dent);
      }
    });
    expectFound(scene, seed, 0.002, 0.0005);
  }
}

TEST(UnevenTops, roundedEdgesEndAtTheFacesOnAllSides) {
  for (std::uint64_t seed = 720; seed < 726; ++seed) {
    const Scene scene = shapedScene(
        seed, [](SceneBox& box, Random& random) { box.shape.rounding_m = between(random, 0.003, 0.008); });
    expectFound(scene, seed, 0.003, 0.0003);
  }
}

TEST(UnevenTops, aBulgeIsFollowedToItsEdges) {
  for (std::uint64_t seed = 740; seed < 746; ++seed) {
    const Scene scene = shapedScene(seed, [](SceneBox& box, Random& random) {
      box.shape.bulge_m = between(random, 0.002, 0.008) * (random() % 2 == 0 ? 1.0 : -1.0);
    });
    expectFound(scene, seed, 0.002, 0.0005);
  }
}

TEST(UnevenTops, theTopOfALowerNeighbourIsNoFaceOfARoundedEdge) {
  for (std::uint64_t seed = 760; seed < 766; ++seed) {
    Random random(seed);
    Scene scene = simulation::recipeScene(test::sceneRecipe(0.0002, 1280, 800), seed, 0);
    scene.boxes.resize(1);
    SceneBox& high = scene.boxes.front();
    high.size_m = Eigen::Vector3d(0.20, 0.14, 0.10);
    high.shape.rounding_m = between(random, 0.003, 0.006);
    SceneBox low = high;
    low.shape = {};
    low.size_m.z() = high.size_m.z() - 0.02;
    const Eigen::Vector2d across(-std::sin(high.yaw_rad), std::cos(high.yaw_rad));
    low.position_m += (0.14 + 0.001) * (random() % 2 == 0 ? 1.0 : -1.0) * across;
    scene.boxes.push_back(low);
    const auto capture = simulation::capture(scene, seed);
    BoxDetector detector{DetectionOptions()};
    const Detections found = detector.detect(capture.cloud.view(), test::trueBaseFromCamera(scene));
    const test::TrueBox truth = test::trueBoxes(scene).front();
    const DetectedBox* box = test::nearest(found, truth);
    ASSERT_NE(box, nullptr) << "seed " << seed;
    EXPECT_LT((box->size - truth.size).head<2>().cwiseAbs().maxCoeff(), 0.003) << "seed " << seed;
  }
}

TEST(UnevenTops, anOpenFlapIsNoBox) {
  for (std::uint64_t seed = 780; seed < 786; ++seed) {
    const Scene scene = shapedScene(seed, [](SceneBox& box, Random& random) {
      box.shape.bulge_m = 0.003;
      simulation::BoxFlap flap;
      flap.side = random() % 2 == 0 ? simulation::BoxFace::kPlusX : simulation::BoxFace::kMinusY;
      flap.angle_rad = between(random, 2.3, 2.6);
      box.shape.flaps.push_back(flap);
    });
    const auto capture = simulation::capture(scene, seed);
    BoxDetector detector{DetectionOptions()};
    const Detections found = detector.detect(capture.cloud.view(), test::trueBaseFromCamera(scene));
    EXPECT_LE(found.boxes.size(), scene.boxes.size()) << "seed " << seed;
  }
}

}  // namespace
}  // namespace mixed_palletizing::detection

// Uneven tops: closed solids, surfaces where the formulas say, truth that agrees with the points, rules.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include <mixed_palletizing/simulation/capture.hpp>

#include "box_mesh.hpp"
#include "small_scenes.hpp"

namespace mixed_palletizing::simulation {
namespace {

SceneBox unevenBox(std::uint32_t seed, bool with_flaps) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  SceneBox box;
  box.size_m = {between(0.15, 0.4), between(0.15, 0.3), between(0.08, 0.25)};
  box.yaw_rad = between(-3.0, 3.0);
  if (seed % 3 != 0) box.shape.bulge_m = between(-0.008, 0.008);
  if (seed % 2 != 0) box.shape.rounding_m = between(0.001, 0.008);
  for (std::uint32_t i = 0; i < seed % 4; ++i) {
    const Eigen::Vector2d share(between(-0.5, 0.5), between(-0.5, 0.5));
    const Eigen::Vector2d center = share.cwiseProduct(box.size_m.head<2>());
    box.shape.dents.push_back({center, between(0.005, 0.06), between(0.001, 0.012)});
  }
  if (!with_flaps) return box;
  for (const BoxFace side : {BoxFace::kMinusX, BoxFace::kPlusX, BoxFace::kMinusY, BoxFace::kPlusY}) {
    box.shape.flaps.push_back({side, between(0.03, 0.1), between(0.1, 4.5)});
  }
  return box;
}

using Edge = std::array<long, 6>;

/// Volume of the mesh; fails unless every edge is run once in either direction.
double volumeOfClosed(const Mesh& mesh) {
  std::map<Edge, int> runs;
  double volume = 0.0;
  for (const auto& triangle : mesh.triangles) {
    std::array<Eigen::Vector3d, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = mesh.vertices[triangle[i]];
    volume += p[0].dot(p[1].cross(p[2])) / 6.0;
    for (std::size_t i = 0; i < 3; ++i) {
      Edge forth;
      Edge back;
      for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        forth[a] = back[a + 3] = std::lround(p[i][axis] * 1e9);
        forth[a + 3] = back[a] = std::lround(p[(i + 1) % 3][axis] * 1e9);
      }
      ++runs[forth];
      --runs[back];
    }
  }
  for (const auto& [edge, count] : runs) EXPECT_EQ(count, 0);
  return volume;
}

TEST(BoxShape, SolidsAreClosedAndFacingOutwards) {
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    SceneBox box = unevenBox(seed, false);
    const double nominal = box.size_m.prod();
    const TopOffsets offsets = topOffsets(box);
    const double lift = offsets.mean_m * box.size_m.x() * box.size_m.y();
    EXPECT_NEAR(volumeOfClosed(boxMesh(box, geometry::Pose::Identity())), nominal + lift, 0.012 * nominal);
    const double closed = volumeOfClosed(boxMesh(box, geometry::Pose::Identity()));
    box.shape.flaps.push_back({BoxFace::kMinusY, 0.05, 2.0});
    const double flap = (box.size_m.x() - 2.0 * box.shape.rounding_m) * 0.05 * 0.003;
    EXPECT_NEAR(volumeOfClosed(boxMesh(box, geometry::Pose::Identity())), closed + flap, 1e-9);
  }
}

TEST(BoxShape, PointsOfTheTopLieWhereTheFormulaSays) {
  for (std::uint32_t seed = 1; seed <= 24; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scene scene = bareFloor(0.9);
    scene.camera.world_from_camera = lookAt({0.3, -0.4, 0.9}, {0.0, 0.0, 0.1});
    scene.boxes = {unevenBox(seed, false)};
    const SceneBox& box = scene.boxes[0];
    const Capture result = capture(scene, seed);
    std::size_t seen = 0;
    for (std::size_t i = 0; i < result.mask.size(); ++i) {
      if (result.mask[i] == 0) continue;
      const Eigen::Vector3d place = worldFromBox(box).inverse() * worldPoint(scene, result.cloud.points[i]);
      const Eigen::Array2d inner = 0.5 * box.size_m.head<2>().array() - box.shape.rounding_m - 1e-4;
      if ((place.head<2>().array().abs() > inner).any()) continue;
      ++seen;
      ASSERT_NEAR(place.z(), 0.5 * box.size_m.z() + topOffset(box, place.head<2>()), 5e-5) << i;
    }
    EXPECT_GT(seen, 1000u);
  }
}

TEST(BoxShape, RoundedEdgesLieOnTheirBalls) {
  SceneBox box;
  box.shape.rounding_m = 0.008;
  const Mesh mesh = boxMesh(box, geometry::Pose::Identity());
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3d middle =
        (mesh.vertices[triangle[0]] + mesh.vertices[triangle[1]] + mesh.vertices[triangle[2]]) / 3.0;
    const Eigen::Array3d inner = 0.5 * box.size_m.array() - 0.008;
    const Eigen::Vector3d center = middle.array().min(inner).max(-inner).matrix();
    EXPECT_NEAR((middle - center).norm(), 0.008, 4e-5);
  }
}

TEST(BoxShape, TruthAgreesWithThePoints) {
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scene scene = bareFloor(1.2, 640);
    scene.boxes = {unevenBox(seed, false)};
    SceneBox& box = scene.boxes[0];
    const TopOffsets offsets = topOffsets(box);
    const Capture result = capture(scene, seed);
    double sum = 0.0;
    double count = 0.0;
    double lowest = 0.0;
    double highest = 0.0;
    for (std::size_t i = 0; i < result.mask.size(); ++i) {
      if (result.mask[i] == 0) continue;
      const Eigen::Vector3d place = worldFromBox(box).inverse() * worldPoint(scene, result.cloud.points[i]);
      const Eigen::Array2d inner = 0.5 * box.size_m.head<2>().array() - box.shape.rounding_m;
      const double offset = place.z() - 0.5 * box.size_m.z();
      if ((place.head<2>().array().abs() > inner).any() || offset < -0.05) continue;
      sum += offset;
      count += 1.0;
      lowest = std::min(lowest, offset);
      highest = std::max(highest, offset);
    }
    EXPECT_NEAR(sum / count, offsets.mean_m, 1e-4);
    EXPECT_NEAR(lowest, offsets.lowest_m, 3e-4);
    EXPECT_NEAR(highest, offsets.highest_m, 3e-4);
    EXPECT_GT(result.top_visibility[0], 0.97);
  }
}

TEST(BoxShape, FlapsBelongToTheirBoxAndStayOutOfIt) {
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    SceneBox box = unevenBox(seed, true);
    const Mesh mesh = boxMesh(box, geometry::Pose::Identity());
    const Eigen::Array3d half = 0.5 * box.size_m.array() - 1e-9;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      if (mesh.faces[i] != kFlapFace) continue;
      for (const std::uint32_t corner : mesh.triangles[i]) {
        EXPECT_FALSE((mesh.vertices[corner].array().abs() < half).all());
      }
    }
    Scene scene = bareFloor(1.2);
    scene.boxes = {box};
    const std::size_t with_flaps = capture(scene, seed).visible_pixels[0];
    for (BoxFlap& flap : scene.boxes[0].shape.flaps) flap.angle_rad = 3.14159;
    const std::size_t spread = capture(scene, seed).visible_pixels[0];
    scene.boxes[0].shape.flaps.clear();
    EXPECT_GE(with_flaps, capture(scene, seed).visible_pixels[0]);
    EXPECT_GT(spread, capture(scene, seed).visible_pixels[0]);
  }
}

TEST(BoxShape, FlagsSayWhatThereIs) {
  BoxShape shape;
  EXPECT_TRUE(shapeFlags(shape).empty());
  shape.bulge_m = 0.001;
  EXPECT_EQ(shapeFlags(shape), std::vector<std::string>{"BULGED"});
  shape.bulge_m = -0.001;
  shape.rounding_m = 0.001;
  shape.dents.resize(1);
  shape.flaps.resize(1);
  const std::vector<std::string> all = {"SAGGED", "ROUNDED_EDGES", "DENTED", "OPEN_FLAPS"};
  EXPECT_EQ(shapeFlags(shape), all);
}

/// The scene after `damage` has one problem, which starts with `key`.
void expectProblem(const std::string& key, const std::function<void(SceneBox&)>& damage) {
  Scene scene = bareFloor(2.0);
  scene.boxes = {unevenBox(7, true)};
  scene.boxes[0].size_m = {0.4, 0.3, 0.2};
  for (BoxDent& dent : scene.boxes[0].shape.dents) dent.center_m.setZero();
  ASSERT_TRUE(problems(scene).empty()) << problems(scene)[0];
  damage(scene.boxes[0]);
  const std::vector<std::string> found = problems(scene);
  ASSERT_EQ(found.size(), 1u) << key;
  EXPECT_EQ(found[0].substr(0, found[0].find(':')), key) << found[0];
}

TEST(BoxShape, ProblemsNameTheirKey) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  expectProblem("boxes[0].shape.bulge_m", [](SceneBox& b) { b.shape.bulge_m = 8.0; });  // millimetres
  expectProblem("boxes[0].shape.bulge_m", [](SceneBox& b) { b.shape.bulge_m = kNan; });
  expectProblem("boxes[0].shape.rounding_m", [](SceneBox& b) { b.shape.rounding_m = -0.001; });
  expectProblem("boxes[0].shape.rounding_m", [](SceneBox& b) { b.shape.rounding_m = 0.021; });
  expectProblem("boxes[0].shape.dents[1].center_m", [](SceneBox& b) { b.shape.dents[1].center_m.x() = 0.3; });
  expectProblem("boxes[0].shape.dents[2].radius_m", [](SceneBox& b) { b.shape.dents[2].radius_m = 0.0; });
  expectProblem("boxes[0].shape.dents[0].depth_m", [](SceneBox& b) { b.shape.dents[0].depth_m = 0.04; });
  expectProblem("boxes[0].shape.dents", [](SceneBox& b) { b.shape.dents.assign(33, BoxDent()); });
  expectProblem("boxes[0].shape.flaps[0].side", [](SceneBox& b) { b.shape.flaps[0].side = BoxFace::kTop; });
  expectProblem("boxes[0].shape.flaps[3].length_m", [](SceneBox& b) { b.shape.flaps[3].length_m = 80.0; });
  expectProblem("boxes[0].shape.flaps[1].angle", [](SceneBox& b) { b.shape.flaps[1].angle_rad = 6.0; });
}

TEST(BoxShape, WhatStandsOnABulgeStandsOnItsHeight) {
  Scene scene = bareFloor(2.0);
  scene.boxes.resize(2);
  scene.boxes[0].shape.bulge_m = 0.005;
  scene.boxes[1].base_z_m = scene.boxes[0].size_m.z();
  EXPECT_EQ(problems(scene), std::vector<std::string>{"boxes[1]: overlaps boxes[0]"});
  scene.boxes[1].base_z_m += 0.005;
  EXPECT_TRUE(problems(scene).empty());
}

}  // namespace
}  // namespace mixed_palletizing::simulation

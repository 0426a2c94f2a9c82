// Cylinders, cuboids and meshes in a scene: where they are, what hides what, masks, warnings, rules.
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <mixed_palletizing/simulation/capture.hpp>

#include "analytic_rays.hpp"
#include "small_scenes.hpp"

namespace mixed_palletizing::simulation {
namespace {

constexpr double kPi = 3.14159265358979323846;

SceneObject objectOf(TriangleMesh mesh, const geometry::Pose& pose) {
  SceneObject object;
  object.mesh = std::make_shared<TriangleMesh>(std::move(mesh));
  object.world_from_object = pose;
  return object;
}

geometry::Pose randomPose(std::mt19937& random, double height) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const Eigen::Vector3d place(0.3 * unit(random), 0.2 * unit(random), height + 0.1 * unit(random));
  return poseFromRollPitchYaw(place, kPi * Eigen::Vector3d(unit(random), unit(random), unit(random)));
}

double volumeOf(const TriangleMesh& mesh) {
  double volume = 0.0;
  for (const auto& t : mesh.triangles) {
    volume += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6.0;
  }
  return volume;
}

TEST(TriangleMesh, SolidsHaveTheirVolumeAndSurroundWhatIsInside) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> length(0.01, 0.5);
  for (int i = 0; i < 20; ++i) {
    const double radius = length(random);
    const double height = length(random);
    const TriangleMesh cylinder = cylinderMesh(radius, height);
    EXPECT_NEAR(volumeOf(cylinder), kPi * radius * radius * height, 0.005 * radius * radius * height * kPi);
    EXPECT_NEAR(windingNumber(cylinder, {0.0, 0.5 * radius, 0.5 * height}), 1.0, 1e-9);
    EXPECT_NEAR(windingNumber(cylinder, {0.0, 1.1 * radius, 0.5 * height}), 0.0, 1e-9);
    const Eigen::Vector3d size(length(random), length(random), length(random));
    const TriangleMesh cuboid = cuboidMesh(size);
    EXPECT_NEAR(volumeOf(cuboid), size.prod(), 1e-12);
    EXPECT_TRUE(extentOf(cuboid).high.isApprox(Eigen::Vector3d(0.5 * size.x(), 0.5 * size.y(), size.z())));
    EXPECT_NEAR(windingNumber(cuboid, {0.0, 0.0, 0.5 * size.z()}), 1.0, 1e-9);
  }
}

TEST(Pose, RollPitchYawTurnAboutFixedAxes) {
  const geometry::Pose pose = poseFromRollPitchYaw({1, 2, 3}, {0.5 * kPi, 0.0, 0.5 * kPi});
  EXPECT_TRUE(pose.linear().col(0).isApprox(Eigen::Vector3d::UnitY()));
  EXPECT_TRUE(pose.linear().col(1).isApprox(Eigen::Vector3d::UnitZ()));
  EXPECT_TRUE((pose * Eigen::Vector3d::Zero()).isApprox(Eigen::Vector3d(1, 2, 3)));
}

TEST(Objects, TurnedCuboidsLieWhereTheirPoseSays) {
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const Eigen::Vector3d size(0.2, 0.12, 0.3);
    Scene scene = bareFloor(1.5);
    scene.objects = {objectOf(cuboidMesh(size), randomPose(random, 0.4))};
    const Capture result = capture(scene, seed);
    std::size_t seen = 0;
    for (std::size_t i = 0; i < result.mask.size(); ++i) {
      const Eigen::Vector3d point =
          scene.objects[0].world_from_object.inverse() * worldPoint(scene, result.cloud.points[i]);
      const Eigen::Vector3d from_middle = point - Eigen::Vector3d(0.0, 0.0, 0.5 * size.z());
      const double outside = (from_middle.cwiseAbs() - 0.5 * size).maxCoeff();
      if (result.mask[i] == 1) {
        ASSERT_NEAR(outside, 0.0, 1e-5) << i;
        ++seen;
      } else {
        ASSERT_GT(outside, 1e-6) << i;
      }
    }
    EXPECT_GT(seen, 100u);
    EXPECT_EQ(result.object_visible_pixels, std::vector<std::size_t>{seen});
  }
}

TEST(Objects, CylindersLieWithinTheirChordsOfTheRoundOne) {
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Scene scene = bareFloor(1.5);
    scene.objects = {objectOf(cylinderMesh(0.1, 0.25), randomPose(random, 0.4))};
    const Capture result = capture(scene, seed);
    for (std::size_t i = 0; i < result.mask.size(); ++i) {
      if (result.mask[i] == 0) continue;
      const Eigen::Vector3d point =
          scene.objects[0].world_from_object.inverse() * worldPoint(scene, result.cloud.points[i]);
      const double beside = point.head<2>().norm() - 0.1;
      const double beyond = std::abs(point.z() - 0.125) - 0.125;
      ASSERT_NEAR(std::max(beside, beyond), 0.0, 5e-5) << i;
    }
  }
}

TEST(Objects, ACuboidIsSeenAsABoxOfItsSize) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scene boxes = smallScene(seed);
    Scene mixed = boxes;
    const SceneBox last = mixed.boxes.back();
    mixed.boxes.pop_back();
    geometry::Pose pose = worldFromBox(last);
    pose.translation().z() = last.base_z_m;
    mixed.objects = {objectOf(cuboidMesh(last.size_m), pose)};
    const Capture one = capture(boxes, seed);
    const Capture two = capture(mixed, seed);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < one.mask.size(); ++i) differing += one.mask[i] == two.mask[i] ? 0 : 1;
    EXPECT_LE(static_cast<double>(differing), kEdgeRatio * static_cast<double>(one.mask.size()));
    EXPECT_NEAR(static_cast<double>(two.object_visible_pixels[0]),
                static_cast<double>(one.visible_pixels.back()), 200.0);
    EXPECT_EQ(two.visible_pixels.size(), mixed.boxes.size());
  }
}

TEST(Objects, SameSeedSameBytesWhateverTheThreads) {
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Scene scene = smallScene(seed, 321);  // no multiple of the rays that are cast together
    scene.noise = {0.0005, true, 0.02, 0.4, 0.02, 1.0, 2.0};
    scene.camera.projector_m = Eigen::Vector3d(0.1, 0.0, 0.0);
    scene.boxes[0].shape.bulge_m = 0.006;
    scene.boxes[0].shape.rounding_m = 0.004;
    scene.boards.resize(1);
    scene.objects = {objectOf(cylinderMesh(0.05, 0.1), randomPose(random, 0.5))};
    const Capture one = capture(scene, seed, 1);
    const Capture two = capture(scene, seed, 2);
    const std::size_t bytes = one.cloud.points.size() * sizeof(geometry::ColoredPoint);
    EXPECT_EQ(std::memcmp(one.cloud.points.data(), two.cloud.points.data(), bytes), 0);
    EXPECT_TRUE(one.mask == two.mask);
    EXPECT_EQ(one.visible_pixels, two.visible_pixels);
    EXPECT_EQ(one.object_visible_pixels, two.object_visible_pixels);
    EXPECT_EQ(one.top_visibility, two.top_visibility);
  }
}

TEST(Objects, WarningsSayWhatReachesIntoWhat) {
  const auto at = [](double x, double z) {
    return poseFromRollPitchYaw({x, 0.0, z}, Eigen::Vector3d::Zero());
  };
  Scene scene = bareFloor(2.0);
  scene.boxes.resize(1);  // 0.3 long, 0.15 high
  EXPECT_TRUE(warnings(scene).empty());
  scene.objects = {objectOf(cuboidMesh({0.2, 0.1, 0.1}), at(0.25, 0.0)),  // touches the box
                   objectOf(cylinderMesh(0.05, 0.2), at(0.0, 0.15)),      // stands on it
                   objectOf(cylinderMesh(0.05, 0.1), at(0.25, 0.1))};     // stands on the cuboid
  EXPECT_TRUE(warnings(scene).empty()) << warnings(scene)[0];
  scene.objects[0].world_from_object = at(0.245, 0.0);
  EXPECT_EQ(warnings(scene), std::vector<std::string>{"objects[0]: reaches into boxes[0]"});
  scene.objects[0].world_from_object = at(0.25, 0.0);
  scene.objects[1].world_from_object = at(0.0, 0.147);
  EXPECT_EQ(warnings(scene), std::vector<std::string>{"objects[1]: reaches into boxes[0]"});
  scene.objects[1] = objectOf(cylinderMesh(0.02, 0.05), at(0.0, 0.05));  // within the box
  EXPECT_EQ(warnings(scene), std::vector<std::string>{"objects[1]: reaches into boxes[0]"});
  scene.objects.resize(1);
  scene.objects[0].world_from_object = at(1.0, -0.01);
  EXPECT_EQ(warnings(scene), std::vector<std::string>{"objects[0]: reaches 0.01 m below the floor"});
}

TEST(Objects, WarningsHoldForTurnedThings) {
  for (std::uint32_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> offset(-0.3, 0.3);
    Scene scene = bareFloor(3.0);
    const geometry::Pose one = randomPose(random, 1.0);
    geometry::Pose two = randomPose(random, 1.0);
    two.translation() =
        one * Eigen::Vector3d(0, 0, 0.05) + Eigen::Vector3d(offset(random), offset(random), 0.0);
    two.translation() -= two.linear() * Eigen::Vector3d(0, 0, 0.05);
    const double distance = (one * Eigen::Vector3d(0, 0, 0.05) - two * Eigen::Vector3d(0, 0, 0.05)).norm();
    scene.objects = {objectOf(cuboidMesh({0.1, 0.1, 0.1}), one), objectOf(cuboidMesh({0.1, 0.1, 0.1}), two)};
    const std::size_t count = warnings(scene).size();
    EXPECT_TRUE(distance > 0.095 || count == 1) << distance;  // the balls within them meet
    EXPECT_TRUE(distance < 0.174 || count == 0) << distance;  // those around them do not
  }
}

/// The scene after `damage` has one problem, which starts with `key`.
void expectProblem(const std::string& key, const std::function<void(Scene&)>& damage) {
  Scene scene = bareFloor(2.0);
  scene.objects = {objectOf(cuboidMesh({0.1, 0.1, 0.1}), geometry::Pose::Identity())};
  scene.surfaces.resize(1);
  scene.surfaces[0].name = "table";
  scene.surfaces[0].world_from_surface.translation().z() = 0.5;
  scene.markers.resize(1);
  scene.markers[0].surface = "table";
  scene.boards.resize(1);
  ASSERT_TRUE(problems(scene).empty()) << problems(scene)[0];
  damage(scene);
  const std::vector<std::string> found = problems(scene);
  ASSERT_EQ(found.size(), 1u) << key;
  EXPECT_EQ(found[0].substr(0, found[0].find(':')), key) << found[0];
}

TEST(Objects, ProblemsNameTheirKey) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  expectProblem("objects[0].mesh", [](Scene& s) { s.objects[0].mesh.reset(); });
  expectProblem("objects[0].mesh", [](Scene& s) { s.objects[0].mesh = std::make_shared<TriangleMesh>(); });
  expectProblem("objects[0].mesh", [](Scene& s) {
    TriangleMesh mesh = cuboidMesh({0.1, 0.1, 0.1});
    mesh.vertices.pop_back();
    s.objects[0].mesh = std::make_shared<TriangleMesh>(mesh);
  });
  expectProblem("objects[0].mesh", [](Scene& s) {
    TriangleMesh mesh = cuboidMesh({0.1, 0.1, 0.1});
    mesh.vertices[3].x() = kNan;
    s.objects[0].mesh = std::make_shared<TriangleMesh>(mesh);
  });
  expectProblem("objects[0].pose", [](Scene& s) { s.objects[0].world_from_object.linear() *= 2.0; });
  expectProblem("objects[0].rgb", [](Scene& s) { s.objects[0].rgb = 0x1000000; });
  expectProblem("objects[0]", [](Scene& s) { s.objects[0].world_from_object.translation().z() = 1.95; });
  expectProblem("surfaces[0]", [](Scene& s) {
    s.surfaces[0].world_from_surface.translation().z() = 2.1;
    s.surfaces[0].thickness_m = 0.2;
  });
  expectProblem("surfaces[0].size_m", [](Scene& s) { s.surfaces[0].size_m.x() = 800.0; });
  expectProblem("surfaces[0].thickness_m", [](Scene& s) { s.surfaces[0].thickness_m = -0.1; });
  expectProblem("surfaces[0].pose",
                [](Scene& s) { s.surfaces[0].world_from_surface.translation().x() = kNan; });
  expectProblem("surfaces[1].name", [](Scene& s) { s.surfaces.push_back(s.surfaces[0]); });
  expectProblem("markers[0].surface", [](Scene& s) { s.markers[0].surface = "chair"; });
  expectProblem("markers[0].position_m", [](Scene& s) { s.markers[0].position_m.x() = 0.6; });
  expectProblem("markers[0].id", [](Scene& s) { s.markers[0].id = 50; });
  expectProblem("boards[0].first_id", [](Scene& s) { s.boards[0].first.id = 40; });  // 12 markers
  expectProblem("boards[0].columns", [](Scene& s) { s.boards[0].columns = 0; });
  expectProblem("boards[0].gap_m", [](Scene& s) { s.boards[0].gap_m = -0.1; });
  expectProblem("marker.surface", [](Scene& s) {
    s.has_marker = true;
    s.marker.surface = "table";
  });
}

}  // namespace
}  // namespace mixed_palletizing::simulation

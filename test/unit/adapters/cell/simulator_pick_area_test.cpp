#include <random>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include <mixed_palletizing/adapters/cell/order.hpp>
#include <mixed_palletizing/adapters/cell/simulator_options.hpp>
#include <mixed_palletizing/adapters/cell/simulator_pick_area.hpp>
#include <mixed_palletizing/geometry/rectangle.hpp>
#include <mixed_palletizing/simulation/capture.hpp>
#include <mixed_palletizing/simulation/pinhole.hpp>

namespace mixed_palletizing::cell {
namespace {

geometry::Rectangle footprint(const simulation::SceneBox& box) {
  return {box.position_m, box.yaw_rad, box.size_m.head<2>()};
}

instances::Instance order(std::uint64_t seed) {
  CellOrderOptions options;
  options.seed = seed;
  return cellOrder(options);
}

/// A pick area before the default camera.
struct Cell {
  explicit Cell(std::uint64_t seed, int n_pick = 0)
      : instance(order(seed)),
        scene(cellScene(options)),
        area(instance, n_pick, CellLayout(scene, options.layout), seed) {}

  CellSimulatorOptions options;
  instances::Instance instance;
  simulation::Scene scene;
  PickArea area;
};

void expectFreeStanding(const Cell& cell) {
  const auto& boxes = cell.area.boxes();
  const simulation::Pinhole pinhole(cell.scene.camera);
  const double paper = cell.scene.marker.side_m + 2 * cell.scene.marker.quiet_zone_m;
  const geometry::Rectangle marker{cell.scene.marker.position_m, 0.0, {paper, paper}};
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const geometry::Rectangle own = footprint(boxes[i].solid);
    EXPECT_GE(geometry::distance(own, marker), cell.options.layout.gap_m);
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GE(geometry::distance(own, footprint(boxes[j].solid)), cell.options.layout.gap_m);
    }
    for (const Eigen::Vector2d& corner : own.corners()) {
      for (const double z : {0.0, boxes[i].solid.size_m.z()}) {
        const Eigen::Vector3d world(corner.x(), corner.y(), z);
        const Eigen::Vector3d seen = cell.scene.camera.world_from_camera.inverse() * world;
        ASSERT_GT(seen.z(), 0.0);
        const Eigen::Vector2d uv = pinhole.project(seen);
        EXPECT_TRUE(uv.x() > 0 && uv.y() > 0 && uv.x() < cell.scene.camera.width_px - 1 &&
                    uv.y() < cell.scene.camera.height_px - 1)
            << "corner at pixel " << uv.transpose();
      }
    }
  }
}

TEST(PickArea, EveryItemComesOnceAndStandsFree) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Cell cell(seed, 1 + static_cast<int>(seed % 4));
    const std::size_t n_pick = 1 + seed % 4;
    std::mt19937_64 random(seed);
    std::vector<int> counts(cell.instance.order.types.size(), 0);
    std::set<int> items;
    std::size_t left = static_cast<std::size_t>(cell.instance.order.itemCount());
    while (left > 0) {
      EXPECT_EQ(cell.area.boxes().size(), std::min(n_pick, left));
      EXPECT_EQ(cell.area.waiting(), left - cell.area.boxes().size());
      expectFreeStanding(cell);
      if (HasFailure()) return;
      const PickAreaBox taken = cell.area.take(random() % cell.area.boxes().size(), false);
      EXPECT_TRUE(items.insert(taken.item).second) << "item " << taken.item << " came twice";
      EXPECT_EQ(cell.instance.arrival[static_cast<std::size_t>(taken.item)], taken.type);
      ++counts[static_cast<std::size_t>(taken.type)];
      --left;
    }
    EXPECT_EQ(counts, cell.instance.order.counts);
    EXPECT_TRUE(cell.area.boxes().empty());
  }
}

TEST(PickArea, NextBoxesComeTogetherWhenAllWereThrownOut) {
  Cell cell(3);
  ASSERT_EQ(cell.area.boxes().size(), 3U);
  const std::size_t waiting = cell.area.waiting();
  cell.area.take(1, true);
  cell.area.take(0, true);
  EXPECT_EQ(cell.area.boxes().size(), 1U);
  EXPECT_EQ(cell.area.waiting(), waiting);
  cell.area.take(0, true);
  EXPECT_EQ(cell.area.boxes().size(), 3U);
  EXPECT_EQ(cell.area.waiting(), waiting - 3);
  EXPECT_EQ(cell.area.boxes().front().item, 3);
  // A packed box brings the next ones, also in place of those that were thrown out before.
  cell.area.take(2, true);
  cell.area.take(1, false);
  EXPECT_EQ(cell.area.boxes().size(), 3U);
  EXPECT_EQ(cell.area.waiting(), waiting - 5);
}

TEST(PickArea, PlacesFollowFromTheSeed) {
  Cell a(5);
  Cell b(5);
  Cell c(6);
  for (int i = 0; i < 8; ++i) {
    ASSERT_EQ(a.area.boxes().size(), b.area.boxes().size());
    for (std::size_t j = 0; j < a.area.boxes().size(); ++j) {
      EXPECT_EQ(a.area.boxes()[j].solid.position_m, b.area.boxes()[j].solid.position_m);
      EXPECT_EQ(a.area.boxes()[j].solid.yaw_rad, b.area.boxes()[j].solid.yaw_rad);
    }
    EXPECT_NE(a.area.boxes()[0].solid.position_m, c.area.boxes()[0].solid.position_m);
    a.area.take(0, false);
    b.area.take(0, false);
    c.area.take(0, false);
  }
}

/// The ray caster as an independent judge.
TEST(PickArea, TopsAndMarkerAreSeenWhole) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Cell cell(seed);
    simulation::Scene scene = cell.scene;
    scene.camera.width_px = 384;
    scene.camera.height_px = 240;
    const simulation::Scene bare = scene;
    for (int i = 0; i < 5; ++i) {
      scene.boxes.clear();
      for (const PickAreaBox& box : cell.area.boxes()) scene.boxes.push_back(box.solid);
      const simulation::Capture captured = simulation::capture(scene, seed);
      for (const double share : captured.top_visibility) EXPECT_GT(share, 0.999);
      const simulation::Pinhole pinhole(scene.camera);
      for (const Eigen::Vector3d& corner : simulation::markerCorners(scene.marker)) {
        const Eigen::Vector2d uv = pinhole.project(scene.camera.world_from_camera.inverse() * corner);
        const auto pixel =
            static_cast<std::size_t>(std::lround(uv.y()) * scene.camera.width_px + std::lround(uv.x()));
        EXPECT_EQ(captured.mask.at(pixel), 0) << "a box hides a corner of the marker";
      }
      cell.area.take(0, false);
    }
  }
}

TEST(PickArea, FindsTheBoxAtAPoint) {
  Cell cell(2);
  const auto& boxes = cell.area.boxes();
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const simulation::SceneBox& solid = boxes[i].solid;
    const Eigen::Vector3d top(solid.position_m.x(), solid.position_m.y(), solid.size_m.z());
    EXPECT_EQ(cell.area.find(top, 0.001), i);
    EXPECT_EQ(cell.area.find(top + Eigen::Vector3d(0, 0, 0.009), 0.01), i);
    EXPECT_FALSE(cell.area.find(top + Eigen::Vector3d(0, 0, 0.011), 0.01));
    EXPECT_EQ(cell.area.find(top, 10.0), i) << "the box itself is nearer than any other";
  }
  EXPECT_FALSE(cell.area.find({0, 0, 0}, 0.01)) << "there is the marker";
  EXPECT_FALSE(cell.area.find(Eigen::Vector3d::Constant(NAN), 10.0));
}

TEST(PickArea, RefusesWhatCannotBe) {
  Cell cell(1);
  EXPECT_THROW(cell.area.take(3, false), std::invalid_argument);
  const CellLayout layout(cell.scene, cell.options.layout);
  EXPECT_THROW(PickArea(cell.instance, -1, layout, 1), std::invalid_argument);
  EXPECT_THROW(PickArea(cell.instance, 40, layout, 1), std::invalid_argument) << "no view is that large";
  instances::Instance unsound = cell.instance;
  unsound.arrival.pop_back();
  EXPECT_THROW(PickArea(unsound, 0, layout, 1), std::invalid_argument);
}

/// Tall and low boxes so near to each other that only hiding matters: the layout and the ray caster agree.
TEST(CellLayout, AllowsExactlyWhatHidesNothing) {
  CellSimulatorOptions options;
  options.layout.gap_m = 1e-4;
  const simulation::Scene whole = cellScene(options);
  const CellLayout layout(whole, options.layout);
  simulation::Scene scene = whole;
  scene.camera.width_px = 768;
  scene.camera.height_px = 480;
  scene.has_marker = false;
  int allowed = 0;
  int refused = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    simulation::SceneBox low;
    low.size_m = {0.3, 0.2, 0.1};
    ASSERT_TRUE(layout.place(low, {}, random));
    simulation::SceneBox tall;
    tall.size_m = {0.3, 0.2, 0.5};
    const double towards = std::uniform_real_distribution<double>(-M_PI, M_PI)(random);
    const double apart = std::uniform_real_distribution<double>(0.3, 0.5)(random);
    tall.position_m = low.position_m + apart * Eigen::Vector2d(std::cos(towards), std::sin(towards));
    tall.yaw_rad = towards;
    simulation::SceneBox grown = tall;  // beyond the layout's margin and the width of a pixel
    grown.size_m.head<2>() += Eigen::Vector2d::Constant(2 * 0.02);
    if (!layout.allows(tall, {}) || geometry::distance(footprint(grown), footprint(low)) < 0.001) continue;
    if (layout.allows(tall, {low})) {
      ++allowed;
      scene.boxes = {low, tall};
      EXPECT_GT(simulation::capture(scene, seed).top_visibility[0], 0.999);
    } else {
      ++refused;
      scene.boxes = {low, grown};
      EXPECT_LT(simulation::capture(scene, seed).top_visibility[0], 1.0) << "not even near to hiding";
    }
    EXPECT_EQ(layout.allows(tall, {low}), layout.allows(low, {tall}));
  }
  EXPECT_GT(allowed, 5);
  EXPECT_GT(refused, 5);
}

TEST(CellLayout, KeepsTheMarkerInView) {
  const CellSimulatorOptions options;
  const simulation::Scene scene = cellScene(options);
  const CellLayout layout(scene, options.layout);
  // The camera hangs on the +x side of the marker, so a high box there stands between the two.
  simulation::SceneBox box;
  box.position_m = {0.27, 0.0};
  box.size_m = {0.2, 0.2, 0.1};
  EXPECT_TRUE(layout.allows(box, {}));
  box.size_m.z() = 0.35;
  EXPECT_FALSE(layout.allows(box, {}));
}

TEST(CellLayout, RefusesCamerasThatCannotWork) {
  CellSimulatorOptions options;
  options.camera.tilt_deg = 75.0;
  EXPECT_THROW(CellLayout(cellScene(options), options.layout), std::invalid_argument) << "horizon";
  options.camera.tilt_deg = 20.0;
  options.camera.target_m = {3.0, 0.0};
  EXPECT_THROW(CellLayout(cellScene(options), options.layout), std::invalid_argument) << "marker outside";
  CellLayoutOptions layout;
  layout.gap_m = -0.1;
  layout.border_px = NAN;
  layout.tries = 0;
  EXPECT_EQ(problems(layout).size(), 3U);
  EXPECT_THROW(CellLayout(cellScene({}), layout), std::invalid_argument);
}

}  // namespace
}  // namespace mixed_palletizing::cell

#include <gtest/gtest.h>

#include <mixed_palletizing/packing/placement_rule.hpp>
#include <mixed_palletizing/planning/approach.hpp>

#include "support.hpp"

namespace mixed_palletizing::planning {
namespace {

packing::PalletState pallet() { return packing::PalletState(packing::PalletRules{{600, 400, 300}}); }

constexpr packing::Placement boxAt(int x, int y, int z = 0) { return {0, {x, y, z}, {100, 100, 100}}; }

const ApproachOptions kSlanted{20, 50};

TEST(Approach, isStraightUnlessAskedOtherwiseOrAlone) {
  packing::PalletState state = pallet();
  EXPECT_EQ(lastStretch(kSlanted, {}, state, boxAt(0, 0)), (packing::Vec3{}));
  state.place(boxAt(0, 0));
  EXPECT_EQ(lastStretch({}, {}, state, boxAt(100, 0)), (packing::Vec3{}));
  EXPECT_EQ(lastStretch({20, 0}, {}, state, boxAt(100, 0)), (packing::Vec3{}));
  EXPECT_EQ(lastStretch(kSlanted, {}, state, boxAt(150, 0)), (packing::Vec3{})) << "too far to matter";
  EXPECT_EQ(lastStretch(kSlanted, {}, state, boxAt(0, 0, 100)), (packing::Vec3{})) << "it stands below";
}

TEST(Approach, comesFromTheFreeSides) {
  packing::PalletState state = pallet();
  state.place(boxAt(0, 0));
  EXPECT_EQ(lastStretch(kSlanted, {}, state, boxAt(100, 0)), (packing::Vec3{-20, 0, -50}));
  EXPECT_EQ(lastStretch(kSlanted, {}, state, boxAt(0, 100)), (packing::Vec3{0, -20, -50}));
  EXPECT_EQ(lastStretch(kSlanted, {}, state, boxAt(110, 0)), (packing::Vec3{-20, 0, -50}));
  state.place(boxAt(100, 100));
  EXPECT_EQ(lastStretch(kSlanted, {}, state, boxAt(0, 100)), (packing::Vec3{20, -20, -50}));
  state.place(boxAt(200, 0));
  EXPECT_EQ(lastStretch(kSlanted, {}, state, boxAt(100, 0)), (packing::Vec3{0, 20, -50})) << "between two";
}

TEST(Approach, aGripperThatWouldTouchMakesItStraight) {
  packing::PalletState state = pallet();
  state.place(boxAt(0, 0));
  state.place({0, {230, 0, 0}, {100, 100, 200}});  // 30 mm from the place, above the gripper's bottom
  EXPECT_EQ(lastStretch(kSlanted, {}, state, boxAt(100, 0)), (packing::Vec3{-20, 0, -50}));
  const GripperEnvelope wide{150, 100, 20};
  EXPECT_TRUE(clears(wide, state, {0, {100, 0, 100}, {100, 100, 100}}));
  EXPECT_EQ(lastStretch(kSlanted, wide, state, boxAt(100, 0)), (packing::Vec3{}));
}

/// Millimetre by millimetre along the way: neither box nor gripper is ever in a placed box.
TEST(Approach, touchesNothingOnTheWay) {
  std::mt19937_64 rng(321);
  int slanted = 0;
  for (int run = 0; run < 400; ++run) {
    packing::PalletState state(packing::PalletRules{{120, 100, 90}});
    const GripperEnvelope gripper{test::draw(rng, 0, 1) * test::draw(rng, 5, 30), test::draw(rng, 5, 30),
                                  test::draw(rng, 0, 10)};
    const ApproachOptions options{test::draw(rng, 1, 15), test::draw(rng, 1, 30)};
    for (int i = 0; i < 12; ++i) {
      const packing::Vec3 size{test::draw(rng, 8, 40), test::draw(rng, 8, 40), test::draw(rng, 8, 30)};
      const auto found = packing::findPlacement(state, {size}, 0, packing::PlacementRule::kDblf);
      if (!found || !clears(gripper, state, *found)) continue;
      const packing::Vec3 stretch = lastStretch(options, gripper, state, *found);
      if (stretch != packing::Vec3{}) {
        ++slanted;
        EXPECT_EQ(stretch.z, -options.height);
        for (int step = 0; step <= options.height; ++step) {
          const auto along = [&](int total) { return -static_cast<double>(total) * step / options.height; };
          const double x = found->origin.x + along(stretch.x);
          const double y = found->origin.y + along(stretch.y);
          const double z = found->origin.z + along(stretch.z);
          for (const packing::Placement& other : state.placements()) {
            const auto apart = [](double a, double length_a, int b, int length_b) {
              return a + length_a <= b + 1e-9 || a >= b + length_b - 1e-9;
            };
            const bool box_free = apart(x, size.x, other.origin.x, other.size.x) ||
                                  apart(y, size.y, other.origin.y, other.size.y) ||
                                  z >= other.origin.z + other.size.z - 1e-9;
            const bool gripper_free =
                !gripper.isThere() ||
                apart(x + 0.5 * (size.x - gripper.size_x), gripper.size_x, other.origin.x, other.size.x) ||
                apart(y + 0.5 * (size.y - gripper.size_y), gripper.size_y, other.origin.y, other.size.y) ||
                z + size.z - gripper.reach >= other.origin.z + other.size.z - 1e-9;
            ASSERT_TRUE(box_free && gripper_free) << "seed 321, run " << run << ", step " << step;
          }
        }
      }
      state.place(*found);
    }
  }
  EXPECT_GT(slanted, 200);
}

TEST(Approach, badOptionsAreNamed) {
  EXPECT_TRUE(problems(ApproachOptions{}).empty());
  EXPECT_EQ(problems(ApproachOptions{-1, 100000}).size(), 2U);
}

}  // namespace
}  // namespace mixed_palletizing::planning

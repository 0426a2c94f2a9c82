#include <cstdlib>

#include <gtest/gtest.h>

#include <mixed_palletizing/packing/placement_rule.hpp>
#include <mixed_palletizing/planning/gripper_envelope.hpp>
#include <mixed_palletizing/planning/play_arrivals.hpp>

#include "support.hpp"

namespace mixed_palletizing::planning {
namespace {

/// By slices of a millimetre: some point of the envelope lies in a placed box.
bool touchesByPoints(const GripperEnvelope& envelope, const packing::PalletState& pallet,
                     const packing::Placement& p) {
  for (const packing::Placement& other : pallet.placements()) {
    if (other.origin.z + other.size.z <= p.origin.z + p.size.z - envelope.reach) continue;
    const double left = p.origin.x + 0.5 * p.size.x - 0.5 * envelope.size_x;
    const double front = p.origin.y + 0.5 * p.size.y - 0.5 * envelope.size_y;
    for (int x = other.origin.x; x < other.origin.x + other.size.x; ++x) {
      for (int y = other.origin.y; y < other.origin.y + other.size.y; ++y) {
        if (x + 1 > left && x < left + envelope.size_x && y + 1 > front && y < front + envelope.size_y)
          return true;
      }
    }
  }
  return false;
}

TEST(GripperEnvelope, agreesWithLookingAtEveryPoint) {
  std::mt19937_64 rng(101);
  int touching = 0;
  for (int run = 0; run < 300; ++run) {
    packing::PalletState pallet(packing::PalletRules{{60, 50, 40}});
    for (int i = 0; i < 6; ++i) {
      const packing::Vec3 size{test::draw(rng, 5, 30), test::draw(rng, 5, 30), test::draw(rng, 5, 15)};
      const auto place = packing::findPlacement(pallet, {size}, 0, packing::PlacementRule::kDblf);
      if (place) pallet.place(*place);
    }
    const packing::Vec3 size{test::draw(rng, 5, 20), test::draw(rng, 5, 20), test::draw(rng, 5, 15)};
    const auto place = packing::findPlacement(pallet, {size}, 0, packing::PlacementRule::kDblf);
    if (!place) continue;
    const GripperEnvelope envelope{test::draw(rng, 1, 40), test::draw(rng, 1, 40), test::draw(rng, 0, 10)};
    const bool touches = touchesByPoints(envelope, pallet, *place);
    EXPECT_EQ(clears(envelope, pallet, *place), !touches) << "seed 101, run " << run;
    EXPECT_TRUE(clears({}, pallet, *place));
    touching += touches ? 1 : 0;
  }
  EXPECT_GT(touching, 20);
}

TEST(GripperEnvelope, everyMethodKeepsIt) {
  std::mt19937_64 rng(102);
  for (int run = 0; run < 12; ++run) {
    packing::Order order = test::randomOrder(rng);
    order.rules.gap = 0;
    const std::vector<int> arrival = test::shuffledItems(order, rng);
    for (const PlanMethod method : {PlanMethod::kDblf, PlanMethod::kGa, PlanMethod::kBest}) {
      PlayOptions options;
      options.planner.method = method;
      options.planner.best.samples = 2;
      options.planner.genetic.generations = 1;
      options.planner.gripper = {400, 300, 20};
      const PlayResult play = playArrivals(order, arrival, options);
      packing::PalletState pallet(order);
      for (const PlayedPlacement& played : play.placements) {
        EXPECT_TRUE(clears(options.planner.gripper, pallet, played.placement)) << "seed 102, run " << run;
        pallet.place(played.placement);
      }
    }
  }
}

TEST(GripperEnvelope, saysWhyNothingFits) {
  packing::PalletState pallet(packing::PalletRules{{100, 100, 100}});
  pallet.place({0, {0, 0, 0}, {50, 100, 100}});
  const std::vector<packing::ItemType> types = {{"a", {50, 100, 100}, {}, 0, 0}};
  PlannerOptions options;
  const Situation situation{pallet, types, {0}, {1}};
  EXPECT_TRUE(chooseNextPick(situation, options, 1, {}).chosen);
  options.gripper = {60, 60, 10};
  const Decision decision = chooseNextPick(situation, options, 1, {});
  EXPECT_FALSE(decision.chosen);
  EXPECT_NE(decision.options[0].reason.find("gripper"), std::string::npos) << decision.options[0].reason;
  options.gripper.reach = -1;
  EXPECT_EQ(problems(options).size(), 1U);
}

}  // namespace
}  // namespace mixed_palletizing::planning

// All rules of a pallet at once: the packing core against the independent check.
#include <random>

#include <gtest/gtest.h>

#include <mixed_palletizing/instances/files.hpp>
#include <mixed_palletizing/instances/pack_instance.hpp>
#include <mixed_palletizing/packing/placement_rule.hpp>

#include "../../../src/instances/placement_check.hpp"

namespace mixed_palletizing::instances {
namespace {

using packing::PalletState;
using packing::Placement;

int draw(std::mt19937_64& rng, int low, int high) {
  return std::uniform_int_distribution<int>(low, high)(rng);
}

/// Every rule on or off by chance.
Instance randomInstance(std::mt19937_64& rng) {
  Instance instance;
  instance.name = "random";
  packing::Order& order = instance.order;
  order.rules.size = {draw(rng, 20, 40), draw(rng, 20, 40), draw(rng, 20, 40)};
  if (draw(rng, 0, 2) == 0) order.rules.gap = draw(rng, 1, 2);
  if (draw(rng, 0, 1) == 0) order.rules.min_support_ratio = 0.1 * draw(rng, 4, 9);
  if (order.rules.min_support_ratio < 1.0) order.rules.overhang = draw(rng, 0, 3);
  if (draw(rng, 0, 2) == 0) order.rules.max_weight_kg = draw(rng, 60, 120);
  const bool limits = draw(rng, 0, 1) == 0;
  for (int t = draw(rng, 2, 5); t > 0; --t) {
    packing::ItemType type;
    type.name = std::to_string(t);
    type.size = {draw(rng, 4, 15), draw(rng, 4, 15), draw(rng, 4, 15)};
    type.rotations = {true, {draw(rng, 0, 1) == 0, draw(rng, 0, 1) == 0, true}};
    type.weight_kg = draw(rng, 1, 12);
    if (limits && draw(rng, 0, 1) == 0) type.max_load_kg = draw(rng, 1, 20);
    order.types.push_back(type);
    order.counts.push_back(draw(rng, 1, 8));
  }
  return instance;
}

/// A box anywhere near the pallet, often on a top or at an edge.
Placement anyPlacement(const PalletState& state, const packing::Order& order, std::mt19937_64& rng) {
  const int type = draw(rng, 0, static_cast<int>(order.types.size()) - 1);
  const auto sizes = packing::orientations(order.types[static_cast<std::size_t>(type)]);
  const packing::Vec3 size = sizes[rng() % sizes.size()];
  packing::Vec3 at{draw(rng, -4, order.rules.size.x), draw(rng, -4, order.rules.size.y), 0};
  if (!state.placements().empty() && rng() % 4 != 0) {
    const Placement& below = state.placements()[rng() % state.placements().size()];
    at = {below.origin.x + draw(rng, -3, 3), below.origin.y + draw(rng, -3, 3),
          below.origin.z + below.size.z};
  }
  return {type, at, size};
}

TEST(Rules, coreAndCheckAgreeOnEveryPlacement) {
  std::mt19937_64 rng(41);
  int accepted = 0;
  int tried = 0;
  for (int round = 0; round < 1500; ++round) {
    const Instance instance = randomInstance(rng);
    const packing::SpaceKind kind =
        rng() % 3 == 0 ? packing::SpaceKind::kEmpty : packing::SpaceKind::kSupported;
    PalletState state(instance.order, kind);
    for (int step = 0; step < 30; ++step) {
      const Placement p = anyPlacement(state, instance.order, rng);
      std::vector<Placement> with = state.placements();
      with.push_back(p);
      const std::vector<std::string> faults = placementFaults(instance.order, with);
      const std::string reason = state.whyNot(p);
      ASSERT_EQ(reason.empty(), faults.empty())
          << reason << " | " << joinFaults(faults) << ", seed 41, round " << round << ", "
          << formatInstance(instance);
      ASSERT_EQ(state.accepts(p), reason.empty()) << reason << ", seed 41, round " << round;
      ++tried;
      if (!reason.empty()) continue;
      ++accepted;
      const std::vector<double> loads = state.loads();
      const std::vector<packing::Space> spaces = state.spaces();
      state.place(p);
      if (rng() % 3 != 0) continue;
      state.undo();
      ASSERT_EQ(state.loads(), loads) << "undo takes every load back exactly, seed 41, round " << round;
      ASSERT_TRUE(state.spaces() == spaces);
    }
  }
  EXPECT_GT(accepted, tried / 10);
}

TEST(Rules, everyMethodKeepsThemAll) {
  std::mt19937_64 rng(42);
  for (int round = 0; round < 60; ++round) {
    const Instance instance = randomInstance(rng);
    ASSERT_EQ(joinFaults(problems(instance)), "");
    for (const std::string& word : packing::packMethodWords()) {
      PackRun run;
      run.options.method = *packing::packMethodFromString(word);
      run.options.seed = rng();
      run.options.threads = draw(rng, 1, 2);
      run.options.spaces = rng() % 4 == 0 ? packing::SpaceKind::kEmpty : packing::SpaceKind::kSupported;
      run.time_limit_s = 0.0;
      run.max_evaluations = 20;
      run.max_pallets = draw(rng, 0, 2);
      PackingResult packed = packInstance(instance, run);
      PackingResult again = packInstance(instance, run);
      again.decision_ms = packed.decision_ms = {};
      ASSERT_EQ(formatResult(packed, instance), formatResult(again, instance)) << word << ", round " << round;
      const PackingResult result = parseResult(formatResult(packed, instance), instance);
      ASSERT_EQ(joinFaults(checkResult(instance, result)), "")
          << word << ", seed 42, round " << round << ", " << formatInstance(instance);
    }
    ASSERT_EQ(formatInstance(parseInstance(formatInstance(instance))), formatInstance(instance));
  }
}

TEST(Rules, contradictionsAreNamed) {
  Instance instance = parseInstance(
      R"({"name":"a","pallet_mm":[100,100,100],"items":[{"type":"x","size_mm":[10,10,10],"count":2,"weight_kg":5}]})");
  instance.order.rules.overhang = 5;
  EXPECT_NE(joinFaults(problems(instance)).find("contradicts min_support_ratio 1"), std::string::npos);
  instance.order.rules.overhang = 0;
  instance.order.rules.max_weight_kg = 4.0;
  EXPECT_NE(joinFaults(problems(instance)).find("the pallet may carry 4"), std::string::npos);
  EXPECT_THROW(
      parseInstance(
          R"({"name":"a","pallet_mm":[9,9,9],"items":[{"type":"x","size_mm":[1,1,1],"count":2,"max_load_kg":0}]})"),
      std::invalid_argument);
}

}  // namespace
}  // namespace mixed_palletizing::instances

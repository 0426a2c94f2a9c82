#include <cmath>
#include <functional>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

#include <mixed_palletizing/instances/result_summary.hpp>
#include <mixed_palletizing/packing/pallet_state.hpp>

#include "../../../src/instances/placement_check.hpp"
#include "support.hpp"

namespace mixed_palletizing::instances {
namespace {

using packing::Placement;

/// One way to spoil a valid result, and a word the fault must hold.
struct Corruption {
  const char* name;
  const char* word;
  std::function<void(Instance&, PackingResult&, std::mt19937_64&)> spoil;
};

std::size_t any(std::size_t size, std::mt19937_64& rng) { return rng() % size; }

std::vector<Corruption> corruptions() {
  return {
      {"moved in x", "",
       [](auto&, auto& r, auto& g) { r.placements[any(r.placements.size(), g)].placement.origin.x += 1; }},
      {"moved in y", "",
       [](auto&, auto& r, auto& g) { r.placements[any(r.placements.size(), g)].placement.origin.y -= 3; }},
      {"lifted", "",
       [](auto&, auto& r, auto& g) { r.placements[any(r.placements.size(), g)].placement.origin.z += 1; }},
      {"far away", "inside",
       [](auto&, auto& r, auto& g) {
         r.placements[any(r.placements.size(), g)].placement.origin.x = 2000000000;
       }},
      {"negative size", "not positive",
       [](auto&, auto& r, auto& g) { r.placements[any(r.placements.size(), g)].placement.size.z *= -1; }},
      {"two at one place", "overlaps",
       [](auto&, auto& r, auto& g) {
         const std::size_t i = 1 + any(r.placements.size() - 1, g);
         r.placements[i].placement.origin = r.placements[0].placement.origin;
       }},
      {"item twice", "twice",
       [](auto&, auto& r, auto& g) {
         const std::size_t i = 1 + any(r.placements.size() - 1, g);
         r.placements[i].item = r.placements[i - 1].item;
       }},
      {"packed and unpacked", "twice",
       [](auto&, auto& r, auto&) { r.unpacked.push_back(r.placements[0].item); }},
      {"item lost", "neither", [](auto&, auto& r, auto&) { r.placements.pop_back(); }},
      {"unknown item", "does not exist", [](auto&, auto& r, auto&) { r.placements[0].item = 100000; }},
      {"unknown type", "type", [](auto&, auto& r, auto&) { r.placements[0].placement.type = 77; }},
      {"turned", "may not stand so",
       [](auto&, auto& r, auto& g) {
         Placement& p = r.placements[any(r.placements.size(), g)].placement;
         std::swap(p.size.x, p.size.y);
       }},
      {"top first", "supported",
       [](auto&, auto& r, auto&) { std::reverse(r.placements.begin(), r.placements.end()); }},
      {"bottom left out", "supported",
       [](auto&, auto& r, auto&) {
         r.unpacked.push_back(r.placements[0].item);
         r.placements.erase(r.placements.begin());
       }},
      {"wrong utilization", "utilization", [](auto&, auto& r, auto&) { r.utilization = 0.999; }},
      {"utilization NaN", "utilization", [](auto&, auto& r, auto&) { r.utilization = std::nan(""); }},
      {"times out of order", "decision_ms", [](auto&, auto& r, auto&) { r.decision_ms.median_ms = 5.0; }},
      {"another name", "name", [](auto&, auto& r, auto&) { r.name += "x"; }},
      {"gap broken", "gap", [](auto& i, auto&, auto&) { i.order.rules.gap = 1; }},
      {"support ratio", "",
       [](auto& i, auto& r, auto& g) {
         i.order.rules.min_support_ratio = 0.9;
         r.placements[any(r.placements.size(), g)].placement.origin.z += 7;
       }},
  };
}

std::vector<Corruption> playCorruptions() {
  return {
      {"not yet arrived", "not among the available",
       [](auto& i, auto& r, auto&) {
         for (std::size_t k = 0; k < r.placements.size(); ++k) {
           for (std::size_t m = k + static_cast<std::size_t>(i.n_pick); m < r.placements.size(); ++m) {
             if (r.placements[k].placement.type != r.placements[m].placement.type) continue;
             std::swap(r.placements[k].item, r.placements[m].item);
             return;
           }
         }
       }},
      {"more visible than allowed", "visible", [](auto& i, auto&, auto&) { i.n_pick -= 1; }},
      {"less seen than visible", "visible",
       [](auto&, auto& r, auto& g) { r.placements[any(r.placements.size() - 2, g)].available.pop_back(); }},
      {"another arrival", "",
       [](auto& i, auto& r, auto&) {
         i.arrival.clear();
         r.seed = 3;
       }},
      {"available for some", "some placements only",
       [](auto&, auto& r, auto& g) { r.placements[any(r.placements.size(), g)].available.clear(); }},
      {"discarded though it fits", "though item",
       [](auto&, auto& r, auto&) {
         r.unpacked.push_back(r.placements.back().item);
         r.utilization -=
             static_cast<double>(packing::volume(r.placements.back().placement.size)) / (1200.0 * 800 * 600);
         r.placements.pop_back();
       }},
  };
}

bool hasWord(const std::vector<std::string>& faults, const std::string& word) {
  return std::any_of(faults.begin(), faults.end(),
                     [&word](const std::string& fault) { return fault.find(word) != std::string::npos; });
}

TEST(CheckResult, findsEveryCorruption) {
  std::mt19937_64 rng(21);
  for (int index = 0; index < 40; ++index) {
    for (const PackingStructure structure : {PackingStructure::kColumns, PackingStructure::kBlocks}) {
      GeneratorOptions options;
      options.structure = structure;
      const Instance instance = generateInstance(options, 21, index);
      for (const Corruption& corruption : corruptions()) {
        Instance spoiled_instance = instance;
        PackingResult spoiled = test::perfectResult(instance);
        corruption.spoil(spoiled_instance, spoiled, rng);
        const auto faults = checkResult(spoiled_instance, spoiled);
        EXPECT_TRUE(hasWord(faults, corruption.word)) << corruption.name << ", seed 21, index " << index;
      }
      for (const Corruption& corruption : playCorruptions()) {
        Instance spoiled_instance = instance;
        PackingResult spoiled = test::perfectPlay(spoiled_instance);
        const auto before = checkResult(spoiled_instance, spoiled);
        ASSERT_TRUE(before.empty()) << before.front();
        corruption.spoil(spoiled_instance, spoiled, rng);
        const auto faults = checkResult(spoiled_instance, spoiled);
        EXPECT_TRUE(hasWord(faults, corruption.word)) << corruption.name << ", seed 21, index " << index;
      }
    }
  }
}

TEST(CheckResult, refusesABoxPushedUnderAnother) {
  Instance instance;
  instance.name = "bridge";
  instance.order.rules.size = {30, 10, 30};
  instance.order.rules.min_support_ratio = 0.5;
  instance.order.types = {{"post", {10, 10, 10}, {}, 0, 0}, {"board", {20, 10, 5}, {}, 0, 0}};
  instance.order.counts = {2, 1};
  PackingResult result{"bridge", {}, {}, 3000.0 / 9000.0, {}, "", 0};
  result.placements = {{0, {0, {0, 0, 0}, {10, 10, 10}}, {}},
                       {2, {1, {0, 0, 10}, {20, 10, 5}}, {}},
                       {1, {0, {10, 0, 0}, {10, 10, 10}}, {}}};
  EXPECT_TRUE(hasWord(checkResult(instance, result), "cannot be lowered from above: placement 1"));
  EXPECT_TRUE(hasWord(checkResult(instance, result), "centre"));  // it hangs exactly half
  std::swap(result.placements[1], result.placements[2]);
  EXPECT_TRUE(checkResult(instance, result).empty()) << checkResult(instance, result).front();
}

/// The two independent judges of a placement: this room's and the packing core's.
TEST(PlacementCheck, agreesWithThePackingCore) {
  std::mt19937_64 rng(31);
  const auto draw = [&rng](int low, int high) { return std::uniform_int_distribution<int>(low, high)(rng); };
  int valid = 0;
  int places = 0;
  for (int run = 0; run < 400; ++run) {
    packing::PalletRules rules;
    rules.size = {draw(4, 12), draw(4, 12), draw(3, 9)};
    rules.gap = draw(0, 3) == 0 ? 1 : 0;
    const double ratios[] = {1.0, 1.0, 0.75, 0.5, 0.3};
    rules.min_support_ratio = ratios[draw(0, 4)];
    packing::PalletState state(rules);
    for (int i = 0; i < 150; ++i) {
      int z = i % 4 == 0 ? draw(-1, rules.size.z) : 0;
      if (i % 4 > 1 && !state.placements().empty()) {
        const Placement& below = state.placements()[any(state.placements().size(), rng)];
        z = below.origin.z + below.size.z;
      }
      const Placement p{
          0, {draw(-1, rules.size.x), draw(-1, rules.size.y), z}, {draw(0, 6), draw(0, 6), draw(0, 4)}};
      const std::string core = state.whyNot(p);
      const auto faults = placementFaults(rules, state.placements(), p);
      ASSERT_EQ(core.empty(), faults.empty()) << "seed 31, run " << run << ": core '" << core << "', check '"
                                              << (faults.empty() ? "" : faults[0]) << "'";
      ++places;
      if (!core.empty()) continue;
      ++valid;
      state.place(p);
    }
    if (rules.min_support_ratio < 1.0) continue;
    for (int i = 0; i < 10; ++i) {
      const packing::Vec3 size{draw(1, 8), draw(1, 8), draw(1, 6)};
      const bool fits_core =
          std::any_of(state.spaces().begin(), state.spaces().end(), [&](const auto& space) {
            const packing::Vec3 room = space.size();
            return size.x <= room.x && size.y <= room.y && size.z <= room.z;
          });
      EXPECT_EQ(fitsSomewhere(rules, state.placements(), size), fits_core) << "seed 31, run " << run;
    }
  }
  EXPECT_GT(valid, places / 50);
}

TEST(PlacementCheck, allowsTheOrientationsOfTheCore) {
  for (int flags = 0; flags < 16; ++flags) {
    packing::ItemType type{
        "t", {3, 5, 7}, {(flags & 1) != 0, {(flags & 2) != 0, (flags & 4) != 0, (flags & 8) != 0}}, 0, 0};
    const auto less = [](const packing::Vec3& a, const packing::Vec3& b) {
      return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    };
    auto mine = allowedSizes(type);
    auto core = packing::orientations(type);
    std::sort(mine.begin(), mine.end(), less);
    std::sort(core.begin(), core.end(), less);
    EXPECT_EQ(mine, core) << "flags " << flags;
  }
}

TEST(ResultSummary, countsAndRanks) {
  const DecisionTimes times = decisionTimes({5.0, 1.0, 3.0, 2.0, 4.0});
  EXPECT_EQ(times.median_ms, 3.0);
  EXPECT_EQ(times.p99_ms, 5.0);
  EXPECT_EQ(times.max_ms, 5.0);
  EXPECT_EQ(decisionTimes({}).max_ms, 0.0);
  ResultSummary summary;
  EXPECT_EQ(summary.perfectRatio(), 0.0);
  PackingResult result;
  result.utilization = 1.0;
  summary.add(result, {1.0});
  result.unpacked = {3, 4, 5};
  result.utilization = 0.5;
  summary.add(result, {3.0});
  EXPECT_EQ(summary.perfectRatio(), 0.5);
  EXPECT_EQ(summary.meanUnpacked(), 1.5);
  EXPECT_EQ(summary.meanUtilization(), 0.75);
  summary.add(result, {300.0});
  EXPECT_EQ(summary.late(289.0), 0);  // 5 % are more than 10 ms
  EXPECT_EQ(summary.late(285.0), 1);
  EXPECT_EQ(summary.late(1.0), 1);
  EXPECT_EQ(summary.late(0.5), 1);
  EXPECT_NE(summary.text(1.0).find(" max 300.00 late 1"), std::string::npos);
}

TEST(ResultSummary, tellsAllInALine) {
  ResultSummary summary;
  PackingResult result;
  result.utilization = 1.0;
  summary.add(result, {1.0});
  result.unpacked = {3, 4, 5};
  result.utilization = 0.5;
  summary.add(result, {3.0});
  EXPECT_EQ(summary.text(),
            "orders 2  perfect 50.0 %  mean unpacked 1.50  mean utilization 75.00 %"
            "  decision ms median 1.00 p99 3.00 max 3.00");
}

}  // namespace
}  // namespace mixed_palletizing::instances

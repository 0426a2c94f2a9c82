#include <cmath>
#include <cstdio>
#include <fstream>
#include <numeric>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include <mixed_palletizing/packing/placement_rule.hpp>
#include <mixed_palletizing/planning/placement_policy.hpp>

#include "support.hpp"

namespace mixed_palletizing::planning {
namespace {

class WeightsFile : public ::testing::Test {
 protected:
  ~WeightsFile() override { std::remove(path_.c_str()); }

  PolicyWeights read(const std::string& text) const {
    std::ofstream(path_) << text;
    return readPolicyWeights(path_);
  }

  std::string complaint(const std::string& text) const {
    try {
      read(text);
      return "";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  }

  const std::string path_ = ::testing::TempDir() + "weights_" + std::to_string(::getpid());
};

TEST_F(WeightsFile, isReadAsItWasWritten) {
  PolicyWeights weights{};
  for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = static_cast<double>(i) - 3.5;
  EXPECT_EQ(read(formatPolicyWeights(weights, {"a", "b"})), weights);
  EXPECT_EQ(read(formatPolicyWeights(tunedPolicyWeights(), {})).size(), tunedPolicyWeights().size());
}

TEST_F(WeightsFile, faultsAreNamedWithTheirLine) {
  const std::string good = formatPolicyWeights({}, {});
  EXPECT_NE(complaint(good + "none_such 1\n").find("none_such"), std::string::npos);
  EXPECT_NE(complaint(good + "scarcity 1\n")
                .find(":" + std::to_string(kPolicyFeatureCount + 1) + ": 'scarcity' is given twice"),
            std::string::npos);
  EXPECT_NE(complaint("scarcity 1 2\n").find(":1: 'scarcity' needs one finite number"), std::string::npos);
  EXPECT_NE(complaint("scarcity nan\n").find("finite"), std::string::npos);
  EXPECT_NE(complaint("scarcity\n").find("finite"), std::string::npos);
  EXPECT_NE(complaint("").find("'unfit_ratio' is missing"), std::string::npos);
  EXPECT_THROW(readPolicyWeights("/none/such"), std::runtime_error);
}

TEST(PlacementPolicy, countsWhatFits) {
  const std::vector<packing::ItemType> types = {{"half", {100, 50, 50}, {}, 0, 0},
                                                {"quarter", {50, 50, 50}, {}, 0, 0},
                                                {"tall", {50, 50, 100}, {}, 0, 0}};
  packing::PalletState pallet(packing::PalletRules{{100, 100, 100}, 0, 1.0});
  PlacementPolicy policy(types, pallet.rules(), tunedPolicyWeights());
  const packing::Placement first{0, {0, 0, 0}, {100, 50, 50}};
  pallet.place(first);  // free: 100 x 50 on the floor and on top
  const PolicyWeights f = policy.features(pallet, first, {3, 0, 1});
  EXPECT_DOUBLE_EQ(f[kUnfitRatio], 0.0);
  EXPECT_DOUBLE_EQ(f[kScarcity], (3.0 / 3.0 + 1.0 / 3.0) / 4.0);
  EXPECT_DOUBLE_EQ(f[kShortage], 0.0);
  EXPECT_DOUBLE_EQ(f[kLevels], 2.0 / 8.0);
  EXPECT_DOUBLE_EQ(f[kDeadRoom], 0.0);
  EXPECT_DOUBLE_EQ(f[kMergedTop], 1.0);
  // On the floor 2 items of the first type fill all; on top one of it fills its half.
  EXPECT_DOUBLE_EQ(f[kFillRate], 1.0);
  const PolicyWeights full = policy.features(pallet, first, {4, 0, 3});
  EXPECT_DOUBLE_EQ(full[kShortage], (250000.0 + 250000.0) / (4 * 250000.0 + 3 * 250000.0));
  const PolicyWeights none = policy.features(pallet, first, {0, 0, 0});
  EXPECT_DOUBLE_EQ(none[kUnfitRatio], 0.0);
  EXPECT_DOUBLE_EQ(none[kDeadRoom], 0.0);
}

TEST(PlacementPolicy, topsOfOneHeightJoin) {
  const std::vector<packing::ItemType> types = {{"half", {100, 50, 50}, {}, 0, 0}};
  packing::PalletState pallet(packing::PalletRules{{100, 100, 100}, 0, 1.0});
  PlacementPolicy policy(types, pallet.rules(), tunedPolicyWeights());
  pallet.place({0, {0, 0, 0}, {100, 50, 50}});
  const packing::Placement second{0, {0, 50, 0}, {100, 50, 50}};
  pallet.place(second);
  const PolicyWeights f = policy.features(pallet, second, {1});
  EXPECT_DOUBLE_EQ(f[kMergedTop], 0.5);
  EXPECT_DOUBLE_EQ(f[kFillRate], 0.5);
}

TEST(PlacementPolicy, featuresStayFiniteAndFollowNoHistory) {
  std::mt19937_64 rng(71);
  for (int run = 0; run < 40; ++run) {
    packing::Order order = test::randomOrder(rng);
    packing::PalletState pallet(order.rules);
    PlacementPolicy seasoned(order.types, order.rules, tunedPolicyWeights());
    for (const int type : test::shuffledItems(order, rng)) {
      const auto place = packing::findPlacement(pallet, order.types[static_cast<std::size_t>(type)], type,
                                                packing::PlacementRule::kDblf);
      --order.counts[static_cast<std::size_t>(type)];
      if (!place) continue;
      seasoned.prepare(pallet, order.counts);
      const double score = seasoned.score(*place);
      pallet.place(*place);
      PlacementPolicy fresh(order.types, order.rules, tunedPolicyWeights());
      const PolicyWeights f = fresh.features(pallet, *place, order.counts);
      EXPECT_EQ(score, std::inner_product(f.begin(), f.end(), tunedPolicyWeights().begin(), 0.0))
          << "seed 71, run " << run;
      EXPECT_EQ(seasoned.features(pallet, *place, order.counts), f) << "seed 71, run " << run;
      for (const double value : f) EXPECT_TRUE(std::isfinite(value)) << "seed 71, run " << run;
      EXPECT_TRUE(f[kUnfitRatio] >= 0.0 && f[kUnfitRatio] <= 1.0) << "seed 71, run " << run;
    }
  }
}

TEST(SpaceCapacity, agreesWithCountingAfterManyRooms) {
  std::mt19937_64 rng(72);
  const std::vector<std::vector<packing::Vec3>> sizes = {{{30, 20, 10}, {20, 30, 10}}, {{7, 7, 7}}};
  SpaceCapacity capacity(sizes);
  for (int run = 0; run < 5000; ++run) {
    const packing::Vec3 room{test::draw(rng, 1, 60), test::draw(rng, 1, 60), test::draw(rng, 1, 40)};
    const int* row = capacity.of(room);
    const int flat = room.z < 10 ? 0 : std::max((room.x / 30) * (room.y / 20), (room.x / 20) * (room.y / 30));
    EXPECT_EQ(row[0], flat) << "seed 72, run " << run;
    EXPECT_EQ(row[1], room.z < 7 ? 0 : (room.x / 7) * (room.y / 7)) << "seed 72, run " << run;
    EXPECT_EQ(row[2], flat * (room.z / 10)) << "seed 72, run " << run;
  }
}

}  // namespace
}  // namespace mixed_palletizing::planning

#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <mixed_palletizing/detection/box_detector.hpp>
#include <mixed_palletizing/detection/detections.hpp>
#include <mixed_palletizing/detection/options.hpp>

#include "marker_dictionary.hpp"

namespace mixed_palletizing::detection {
namespace {

TEST(DetectionOptions, defaultsAreGood) { EXPECT_TRUE(problems(DetectionOptions()).empty()); }

TEST(DetectionOptions, everyBrokenRuleIsNamedByItsKey) {
  const std::vector<std::pair<std::string, std::function<void(DetectionOptions&)>>> mistakes = {
      {"plane.distance_m", [](auto& o) { o.plane.distance_m = 0.0; }},
      {"plane.probability", [](auto& o) { o.plane.probability = 1.0; }},
      {"plane.max_iterations", [](auto& o) { o.plane.max_iterations = 0; }},
      {"plane.min_inlier_ratio", [](auto& o) { o.plane.min_inlier_ratio = 1.5; }},
      {"marker.dictionary", [](auto& o) { o.marker.dictionary = "DICT_9X9_50"; }},
      {"marker.id", [](auto& o) { o.marker.id = 50; }},
      {"marker.id", [](auto& o) { o.marker.id = -1; }},
      {"noise.sigmas", [](auto& o) { o.noise.sigmas = -1.0; }},
      {"noise.spacings", [](auto& o) { o.noise.spacings = std::nan(""); }},
      {"cluster.min_height_m", [](auto& o) { o.cluster.min_height_m = -0.01; }},
      {"cluster.max_height_m", [](auto& o) { o.cluster.max_height_m = 0.01; }},
      {"cluster.max_height_m", [](auto& o) { o.cluster.max_height_m = 1e9; }},
      {"cluster.neighbor_distance_m", [](auto& o) { o.cluster.neighbor_distance_m = INFINITY; }},
      {"cluster.min_points", [](auto& o) { o.cluster.min_points = 3; }},
      {"top.height_patch_radius_m", [](auto& o) { o.top.height_patch_radius_m = 0.0; }},
      {"top.slice_m", [](auto& o) { o.top.slice_m = 0.0; }},
      {"top.search_depth_m", [](auto& o) { o.top.search_depth_m = 0.0005; }},
      {"top.slice_ratio", [](auto& o) { o.top.slice_ratio = 0.5; }},
      {"top.min_edge_length_m", [](auto& o) { o.top.min_edge_length_m = 0.0; }},
      {"top.new_edge_angle_rad", [](auto& o) { o.top.new_edge_angle_rad = 80.0; }},
      {"top.merge_angle_rad", [](auto& o) { o.top.merge_angle_rad = 1.5; }},
      {"top.uneven_m", [](auto& o) { o.top.uneven_m = 0.0; }},
      {"box.min_side_m", [](auto& o) { o.box.min_side_m = 0.0; }},
      {"box.max_side_m", [](auto& o) { o.box.max_side_m = 0.01; }},
      {"box.min_rectangularity", [](auto& o) { o.box.min_rectangularity = 0.0; }},
      {"box.min_outline_ratio", [](auto& o) { o.box.min_outline_ratio = 1.0; }},
      {"box.touching_distance_m", [](auto& o) { o.box.touching_distance_m = -0.1; }},
  };
  DetectionOptions all_wrong;
  std::set<std::string> keys;
  for (const auto& mistake : mistakes) {
    DetectionOptions options;
    mistake.second(options);
    const auto lines = problems(options);
    ASSERT_EQ(lines.size(), 1u) << mistake.first;
    EXPECT_EQ(lines.front().rfind(mistake.first + ": ", 0), 0u) << lines.front();
    EXPECT_THROW(BoxDetector{options}, std::invalid_argument);
    mistake.second(all_wrong);
    keys.insert(mistake.first);
  }
  // All at once are all reported, but for the few rules that compare two of these values.
  EXPECT_GE(problems(all_wrong).size() + 4, keys.size());
}

TEST(MarkerDictionary, knowsTheirSizes) {
  EXPECT_EQ(dictionarySize("DICT_4X4_50"), 50);
  EXPECT_EQ(dictionarySize("DICT_APRILTAG_36h11"), 587);
  EXPECT_FALSE(dictionarySize("4X4_50"));
  EXPECT_FALSE(dictionaryNumber(""));
}

TEST(RejectReason, everyReasonHasItsWords) {
  std::set<std::string> words;
  for (int value = 1; value <= 5; ++value) words.insert(toString(static_cast<RejectReason>(value)));
  EXPECT_EQ(words.size(), 5u);
  EXPECT_EQ(words.count("unknown"), 0u);
}

}  // namespace
}  // namespace mixed_palletizing::detection

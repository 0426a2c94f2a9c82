#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <mixed_palletizing/experiments/detection_summary.hpp>
#include <mixed_palletizing/experiments/record_json.hpp>

#include "hand_made_boxes.hpp"

namespace mixed_palletizing::experiments {
namespace {

using test::detected;
using test::trueBox;

const geometry::Pose kBase = geometry::Pose::Identity();

BoxRecord foundBox(const TrueBox& truth, const Eigen::Vector3d& shift, unsigned flags = 0) {
  detection::DetectedBox box = detected(truth, 0.001);
  box.top_center += shift;
  box.flags = static_cast<std::uint8_t>(flags);
  return {truth, box, boxErrors(truth, box, kBase, kBase)};
}

SceneRecord sceneOf(std::uint64_t index, const std::vector<BoxRecord>& boxes) {
  SceneRecord record;
  record.index = index;
  record.base_found = true;
  record.boxes = boxes;
  record.found_corners_px.resize(boxes.size());
  return record;
}

TEST(StatisticsOf, KnownNumbers) {
  const ErrorStatistics s = statisticsOf({3.0, -1.0, 1.0, -3.0});
  EXPECT_EQ(s.count, 4u);
  EXPECT_DOUBLE_EQ(s.mean, 2.0);
  EXPECT_DOUBLE_EQ(s.bias, 0.0);
  EXPECT_DOUBLE_EQ(s.rms, std::sqrt(5.0));
  EXPECT_DOUBLE_EQ(s.stddev, std::sqrt(5.0));
  EXPECT_DOUBLE_EQ(s.median, 1.0);
  EXPECT_DOUBLE_EQ(s.worst, 3.0);
  EXPECT_EQ(statisticsOf({}).count, 0u);
  std::vector<double> hundred;
  for (int i = 1; i <= 100; ++i) hundred.push_back(i);
  EXPECT_DOUBLE_EQ(statisticsOf(hundred).p95, 95.0);
}

TEST(Summarize, CountsMissedInventedAndExcusedBoxes) {
  TrueBox cut = trueBox(1.0, 0.0);
  cut.truncated = true;
  TrueBox hidden = trueBox(2.0, 0.0);
  hidden.visible_ratio = 0.1;
  SceneRecord first = sceneOf(7, {foundBox(trueBox(0.0, 0.0), {0.003, 0.004, 0.0}),
                                  {trueBox(0.0, 1.0), {}, {}},
                                  foundBox(cut, {0.5, 0.0, 0.0}, detection::kTruncated),
                                  {hidden, {}, {}}});
  SceneRecord second = sceneOf(8, {foundBox(trueBox(0.0, 0.0), Eigen::Vector3d::Zero())});
  second.invented.push_back(detected(trueBox(3.0, 3.0)));
  second.invented_corners_px.resize(1);
  const DetectionSummary s = summarize({first, second});
  EXPECT_EQ(s.scenes, 2u);
  EXPECT_EQ(s.boxes, 3u);
  EXPECT_EQ(s.found, 2u);
  EXPECT_EQ(s.invented, 1u);
  EXPECT_DOUBLE_EQ(s.recall(), 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(s.precision(), 2.0 / 3.0);
  EXPECT_EQ(s.truncated, 1u);
  EXPECT_EQ(s.truncated_flagged, 1u);
  EXPECT_NEAR(s.position_mm.worst, 5.0, 1e-9);
  EXPECT_NEAR(s.within_2_stddev[kX], 0.5, 1e-12);
  EXPECT_NEAR(s.coverage, 12.0 / 14.0, 1e-12);
  EXPECT_EQ(s.worst_scene, 7u);
}

TEST(Summarize, ASceneWithoutBaseFrameMissesItsBoxesAndIsTheWorst) {
  SceneRecord lost = sceneOf(3, {{trueBox(0.0, 0.0), {}, {}}});
  lost.base_found = false;
  const DetectionSummary s = summarize({sceneOf(2, {foundBox(trueBox(0.0, 0.0), {0.01, 0.0, 0.0})}), lost});
  EXPECT_EQ(s.base_found, 1u);
  EXPECT_DOUBLE_EQ(s.recall(), 0.5);
  EXPECT_EQ(s.worst_scene, 3u);
}

TEST(Summarize, OfNothingIsPerfect) {
  const DetectionSummary s = summarize({});
  EXPECT_DOUBLE_EQ(s.recall(), 1.0);
  EXPECT_DOUBLE_EQ(s.precision(), 1.0);
  EXPECT_FALSE(summaryText(s).empty());
}

TEST(RecordJson, HoldsFoundAndMissedBoxes) {
  SceneRecord record = sceneOf(
      5, {foundBox(trueBox(0.0, 0.0), {0.001, 0.0, 0.0}, detection::kOccluded), {trueBox(0.0, 1.0), {}, {}}});
  record.refusals.push_back("too_small: \"text\"");
  const auto json = nlohmann::json::parse(recordJson(record));
  EXPECT_EQ(json["scene"], 5);
  EXPECT_NEAR(json["boxes"][0]["errors"]["x"].get<double>(), 1.0, 1e-9);
  EXPECT_EQ(json["boxes"][0]["found"]["flags"][0], "OCCLUDED");
  EXPECT_TRUE(json["boxes"][1]["found"].is_null());
  EXPECT_EQ(json["refusals"][0], "too_small: \"text\"");
  const auto summary = nlohmann::json::parse(summaryJson(summarize({record})));
  EXPECT_DOUBLE_EQ(summary["recall"], 0.5);
  EXPECT_EQ(summary["position_mm"]["count"], 1);
}

}  // namespace
}  // namespace mixed_palletizing::experiments

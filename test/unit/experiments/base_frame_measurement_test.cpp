#include <stdexcept>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <mixed_palletizing/experiments/base_frame_measurement.hpp>

namespace mixed_palletizing::experiments {
namespace {

BaseFrameViews smallViews() {
  BaseFrameViews views;
  views.width_px = 1280;
  views.height_px = 800;
  views.max_distance_m = 1.3;
  return views;
}

TEST(MeasureBaseFrame, findsEveryKindOfMarker) {
  const std::uint64_t seed = 71;
  SCOPED_TRACE(seed);
  std::vector<BaseFrameRecord> records;
  for (std::uint64_t i = 0; i < 6; ++i) records.push_back(measureBaseFrame(smallViews(), seed, i));
  for (const MarkerKind kind : {MarkerKind::kNormal, MarkerKind::kInverted, MarkerKind::kBoard}) {
    const BaseFrameSummary summary = summarize(records, kind);
    EXPECT_EQ(summary.views, 2u);
    EXPECT_EQ(summary.found, 2u) << toString(kind);
    EXPECT_GT(summary.position_mm.worst, 0.0);
    EXPECT_LT(summary.position_mm.worst, 0.3) << toString(kind);
    EXPECT_LT(summary.rotation_deg.worst, 0.05) << toString(kind);
    EXPECT_NE(summaryText(toString(kind), summary).find("found 2 of 2"), std::string::npos);
  }
}

TEST(MeasureBaseFrame, isTheSameForTheSameSeed) {
  const BaseFrameRecord one = measureBaseFrame(smallViews(), 5, 1);
  const BaseFrameRecord again = measureBaseFrame(smallViews(), 5, 1);
  EXPECT_EQ(one.dictionary, again.dictionary);
  EXPECT_EQ(one.position_m(), again.position_m());
  const auto record = nlohmann::json::parse(recordJson(one));
  EXPECT_EQ(record["kind"], "inverted");
  EXPECT_EQ(record["found"], true);
  EXPECT_LE(record["tilt_deg"].get<double>(), 61.0);
}

TEST(MeasureBaseFrame, aFrameThatIsNotFoundSaysWhy) {
  BaseFrameViews views = smallViews();
  views.width_px = 48;  // too coarse to read a marker
  views.height_px = 30;
  const BaseFrameRecord record = measureBaseFrame(views, 3, 0);
  EXPECT_FALSE(record.found);
  EXPECT_FALSE(record.message.empty());
  EXPECT_EQ(summarize({record}, MarkerKind::kNormal).found, 0u);
}

TEST(MeasureBaseFrame, refusesViewsThatCannotBeDrawn) {
  const auto broken = [](auto change) {
    BaseFrameViews views = smallViews();
    change(views);
    return views;
  };
  EXPECT_THROW(measureBaseFrame(broken([](auto& v) { v.max_tilt_rad = 1.6; }), 1, 0), std::invalid_argument);
  EXPECT_THROW(measureBaseFrame(broken([](auto& v) { v.min_distance_m = 2.0; }), 1, 0),
               std::invalid_argument);
  EXPECT_THROW(measureBaseFrame(broken([](auto& v) { v.width_px = 0; }), 1, 0), std::invalid_argument);
  EXPECT_THROW(measureBaseFrame(broken([](auto& v) { v.dictionaries.clear(); }), 1, 0),
               std::invalid_argument);
  EXPECT_THROW(measureBaseFrame(broken([](auto& v) { v.dictionaries = {"NONE"}; }), 1, 0),
               std::invalid_argument);
}

}  // namespace
}  // namespace mixed_palletizing::experiments

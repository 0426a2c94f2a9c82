// cfg/Detection.cfg against the options: one set of defaults, and ranges within what the options allow.
#include <gtest/gtest.h>

#include <mixed_palletizing/adapters/detection_tuning.hpp>

namespace mixed_palletizing::adapters {
namespace {

/// Names of the parameters whose values differ.
std::string differences(const DetectionConfig& a, const DetectionConfig& b) {
  std::string names;
  for (const auto& parameter : DetectionConfig::__getParamDescriptions__()) {
    boost::any left, right;
    parameter->getValue(a, left);
    parameter->getValue(b, right);
    bool same = true;
    if (parameter->type == "double") same = boost::any_cast<double>(left) == boost::any_cast<double>(right);
    if (parameter->type == "int") same = boost::any_cast<int>(left) == boost::any_cast<int>(right);
    if (!same) names += " " + parameter->name;
  }
  return names;
}

TEST(DetectionTuning, hasTheDefaultsOfTheOptions) {
  EXPECT_EQ(differences(DetectionConfig::__getDefault__(), toConfig(detection::DetectionOptions())), "");
}

TEST(DetectionTuning, carriesEveryValueThereAndBack) {
  const DetectionConfig high = DetectionConfig::__getMax__();
  EXPECT_EQ(differences(high, toConfig(withConfig(detection::DetectionOptions(), high))), "");
  const DetectionConfig low = DetectionConfig::__getMin__();
  EXPECT_EQ(differences(low, toConfig(withConfig(detection::DetectionOptions(), low))), "");
}

TEST(DetectionTuning, everyValueAtTheEndsOfItsRangeIsAllowedByTheOptions) {
  const detection::DetectionOptions defaults;
  for (const auto& parameter : DetectionConfig::__getParamDescriptions__()) {
    if (parameter->type == "str") continue;
    for (const bool top : {false, true}) {
      // The one value, and the others of its pair (least and most) out of its way.
      DetectionConfig config = toConfig(defaults);
      config.cluster_min_height_m = 0.001;
      config.cluster_max_height_m = 20.0;
      config.box_min_side_m = 0.005;
      config.box_max_side_m = 5.0;
      config.region_min_z_m = -20.0;
      config.region_max_z_m = 20.0;
      DetectionConfig one = config;
      const DetectionConfig& end = top ? DetectionConfig::__getMax__() : DetectionConfig::__getMin__();
      dynamic_reconfigure::Config message;
      parameter->toMessage(message, end);
      parameter->fromMessage(message, one);
      // Ends that exclude each other: a least value at its highest, a most value at its lowest.
      if (parameter->name == "region_min_z_m" && top) continue;
      if (parameter->name == "region_max_z_m" && !top) continue;
      const auto wrong = detection::problems(withConfig(defaults, one));
      EXPECT_TRUE(wrong.empty()) << parameter->name << (top ? " highest: " : " lowest: ")
                                 << (wrong.empty() ? "" : wrong.front());
    }
  }
}

TEST(DetectionTuning, leavesAloneWhatCannotBeTurned) {
  detection::DetectionOptions options;
  options.marker.id = 17;
  options.region.polygon_m = {0, 0, 1, 0, 1, 1};
  const auto turned = withConfig(options, DetectionConfig::__getMax__());
  EXPECT_EQ(turned.marker.id, 17);
  EXPECT_EQ(turned.region.polygon_m.size(), 6u);
}

}  // namespace
}  // namespace mixed_palletizing::adapters

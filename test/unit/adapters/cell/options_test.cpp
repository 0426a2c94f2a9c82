#include <stdexcept>

#include <gtest/gtest.h>

#include <mixed_palletizing/adapters/cell/executive_options.hpp>
#include <mixed_palletizing/adapters/cell/simulator_options.hpp>
#include <mixed_palletizing/adapters/option_reader.hpp>

namespace mixed_palletizing::cell {
namespace {

YAML::Node shipped(const std::string& name) {
  return adapters::loadYaml(std::string(MIXED_PALLETIZING_SOURCE_DIR) + "/config/" + name);
}

std::string refusal(const std::function<void()>& read) {
  try {
    read();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(CellSimulatorOptions, ShippedFileHoldsTheDefaults) {
  const CellSimulatorOptions defaults;
  EXPECT_TRUE(problems(defaults).empty());
  const CellSimulatorOptions read = readCellSimulatorOptions(shipped("cell_simulator.yaml"));
  EXPECT_EQ(read.order.height_mm, defaults.order.height_mm);
  EXPECT_EQ(read.order.seed, defaults.order.seed);
  EXPECT_EQ(read.order.instances, defaults.order.instances);
  EXPECT_EQ(read.order.index, defaults.order.index);
  EXPECT_EQ(read.n_pick, defaults.n_pick);
  EXPECT_EQ(read.frame_id, defaults.frame_id);
  EXPECT_EQ(read.base_frame, defaults.base_frame);
  EXPECT_EQ(read.take_tolerance_m, defaults.take_tolerance_m);
  EXPECT_EQ(read.tf_timeout_s, defaults.tf_timeout_s);
  EXPECT_EQ(read.threads, defaults.threads);
  EXPECT_EQ(read.camera.distance_m, defaults.camera.distance_m);
  EXPECT_EQ(read.camera.tilt_deg, defaults.camera.tilt_deg);
  EXPECT_EQ(read.camera.horizontal_fov_deg, defaults.camera.horizontal_fov_deg);
  EXPECT_EQ(read.camera.width_px, 1920);
  EXPECT_EQ(read.camera.height_px, 1200);
  EXPECT_EQ(read.camera.target_m, defaults.camera.target_m);
  EXPECT_EQ(read.floor.size_x_m, defaults.floor.size_x_m);
  EXPECT_EQ(read.floor.size_y_m, defaults.floor.size_y_m);
  EXPECT_EQ(read.marker.dictionary, defaults.marker.dictionary);
  EXPECT_EQ(read.marker.id, defaults.marker.id);
  EXPECT_EQ(read.marker.side_m, defaults.marker.side_m);
  EXPECT_EQ(read.marker.quiet_zone_m, defaults.marker.quiet_zone_m);
  EXPECT_EQ(read.marker.inverted, defaults.marker.inverted);
  EXPECT_EQ(read.noise.depth_stddev_at_1m_m, defaults.noise.depth_stddev_at_1m_m);
  EXPECT_EQ(read.noise.no_data_on_black, defaults.noise.no_data_on_black);
  EXPECT_EQ(read.noise.dropout_ratio, defaults.noise.dropout_ratio);
  EXPECT_EQ(read.noise.flying_pixel_ratio, defaults.noise.flying_pixel_ratio);
  EXPECT_EQ(read.layout.gap_m, defaults.layout.gap_m);
  EXPECT_EQ(read.layout.border_px, defaults.layout.border_px);
  EXPECT_EQ(read.layout.tries, defaults.layout.tries);
}

TEST(CellExecutiveOptions, ShippedFileHoldsTheDefaults) {
  const CellExecutiveOptions defaults;
  EXPECT_TRUE(problems(defaults).empty());
  const CellExecutiveOptions read = readCellExecutiveOptions(shipped("cell_executive.yaml"));
  EXPECT_EQ(read.order.height_mm, defaults.order.height_mm);
  EXPECT_EQ(read.order.seed, defaults.order.seed);
  EXPECT_EQ(read.order.instances, defaults.order.instances);
  EXPECT_EQ(read.order.index, defaults.order.index);
  EXPECT_EQ(read.dialogue.pallet_id, defaults.dialogue.pallet_id);
  EXPECT_EQ(read.dialogue.close_open, defaults.dialogue.close_open);
  EXPECT_EQ(read.dialogue.time_budget_s, defaults.dialogue.time_budget_s);
  EXPECT_EQ(read.dialogue.retries, defaults.dialogue.retries);
  EXPECT_EQ(read.link.camera, defaults.link.camera);
  EXPECT_EQ(read.link.detector, defaults.link.detector);
  EXPECT_EQ(read.link.planner, defaults.link.planner);
  EXPECT_EQ(read.link.triggers_camera, defaults.link.triggers_camera);
  EXPECT_EQ(read.link.calibration_clouds, defaults.link.calibration_clouds);
  EXPECT_EQ(read.link.cloud_timeout_s, defaults.link.cloud_timeout_s);
  EXPECT_EQ(read.link.calibration_timeout_s, defaults.link.calibration_timeout_s);
  EXPECT_EQ(read.link.call_timeout_s, defaults.link.call_timeout_s);
  EXPECT_EQ(read.link.service_wait_s, defaults.link.service_wait_s);
  EXPECT_EQ(read.link.move_s, defaults.link.move_s);
  EXPECT_EQ(read.report, defaults.report);
  EXPECT_EQ(read.hold_s, defaults.hold_s);
}

TEST(CellSimulatorOptions, ListsEveryMistake) {
  const std::string text = refusal([] {
    readCellSimulatorOptions(
        YAML::Load("{height_mm: 650, n_pick: -1, theads: 2, frame_id: '', camera: {tilt_deg: 95, target_m: "
                   "[1], fov: 3}, "
                   "layout: {gap_m: 0}, threads: many}"));
  });
  for (const char* expected :
       {"height_mm", "n_pick", "theads: nobody knows this key (did you mean 'threads'?)", "frame_id",
        "camera.tilt_deg", "camera.target_m", "camera.fov: nobody knows", "layout.gap_m",
        "threads: many is not a whole number"}) {
    EXPECT_NE(text.find(expected), std::string::npos) << expected << " is missing in:\n" << text;
  }
  EXPECT_NE(refusal([] { readCellSimulatorOptions(YAML::Load("{marker: {dictionary: DICT_9X9}}")); }), "");
  EXPECT_NE(refusal([] { readCellSimulatorOptions(YAML::Load("{noise: {dropout_ratio: 1.5}}")); }), "");
}

TEST(CellExecutiveOptions, ListsEveryMistake) {
  const std::string text = refusal([] {
    readCellExecutiveOptions(YAML::Load(
        "{height_mm: 0, planner: '', retries: -1, cloud_timeout_s: 0, hold_s: -1, time_budget_s: .nan, "
        "calibration_clouds: -2, palet_id: x}"));
  });
  for (const char* expected : {"height_mm", "planner", "retries", "cloud_timeout_s", "hold_s",
                               "time_budget_s", "calibration_clouds", "palet_id: nobody knows"}) {
    EXPECT_NE(text.find(expected), std::string::npos) << expected << " is missing in:\n" << text;
  }
}

}  // namespace
}  // namespace mixed_palletizing::cell

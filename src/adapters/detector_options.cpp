#include <cmath>

#include <mixed_palletizing/adapters/detection_options.hpp>
#include <mixed_palletizing/adapters/detector_options.hpp>
#include <mixed_palletizing/adapters/option_reader.hpp>
#include <mixed_palletizing/adapters/parameters.hpp>

namespace mixed_palletizing::adapters {
namespace {

constexpr int kMostCalibrationClouds = 1000;
constexpr int kLongestQueue = 10000;

}  // namespace

std::vector<std::string> problems(const DetectorOptions& options) {
  std::vector<std::string> all;
  const auto require = [&](bool holds, const std::string& key, const std::string& what) {
    if (!holds) all.push_back(key + ": " + what);
  };
  require(!options.base_frame.empty(), "base_frame", "a name is needed");
  require(options.base_source != BaseSource::kFile || !options.calibration_file.empty(), "calibration_file",
          "a path is needed with base_source file");
  require(options.calibration_clouds >= 1 && options.calibration_clouds <= kMostCalibrationClouds,
          "calibration_clouds",
          std::to_string(options.calibration_clouds) + " is not within 1 and " +
              std::to_string(kMostCalibrationClouds));
  require(options.queue_size >= 1 && options.queue_size <= kLongestQueue, "queue_size",
          std::to_string(options.queue_size) + " is not within 1 and " + std::to_string(kLongestQueue));
  require(std::isfinite(options.cloud_timeout_s) && options.cloud_timeout_s > 0.0, "cloud_timeout_s",
          std::to_string(options.cloud_timeout_s) + " s is not positive");
  require(std::isfinite(options.tf_timeout_s) && options.tf_timeout_s >= 0.0, "tf_timeout_s",
          std::to_string(options.tf_timeout_s) + " s is negative");
  return all;
}

DetectorOptions readDetectorOptions(const YAML::Node& tree) {
  DetectorOptions options;
  OptionReader reader(tree);
  reader.read("base_frame", options.base_frame);
  reader.readWord<BaseSource>("base_source", options.base_source,
                              {{"marker", BaseSource::kMarker},
                               {"floor", BaseSource::kFloor},
                               {"file", BaseSource::kFile},
                               {"tf", BaseSource::kTf}});
  reader.read("publish_tf", options.publish_tf);
  reader.readWord<TfDirection>(
      "tf_direction", options.tf_direction,
      {{"camera_to_base", TfDirection::kCameraToBase}, {"base_to_camera", TfDirection::kBaseToCamera}});
  reader.read("calibration_file", options.calibration_file);
  reader.read("calibration_clouds", options.calibration_clouds);
  reader.read("calibrate_on_start", options.calibrate_on_start);
  reader.read("queue_size", options.queue_size);
  reader.read("cloud_timeout_s", options.cloud_timeout_s);
  reader.read("tf_timeout_s", options.tf_timeout_s);
  reader.read("capture_service", options.capture_service);
  reader.ignore("tuning");             // of dynamic_reconfigure
  reader.ignore("diagnostic_period");  // of diagnostic_updater
  OptionReader detection = reader.section("detection");
  readDetectionOptions(detection, options.detection);
  reader.add(problems(options));
  reader.finish("parameters of the box detector");
  options.calibration_file = expandPath(options.calibration_file);
  return options;
}

}  // namespace mixed_palletizing::adapters

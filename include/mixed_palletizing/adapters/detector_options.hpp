// Private parameters of the detector node.
#pragma once

#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

#include <mixed_palletizing/detection/options.hpp>

namespace mixed_palletizing::adapters {

/// Where the base frame comes from.
enum class BaseSource {
  kMarker,  ///< calibrate: floor plane and marker
  kFloor,   ///< calibrate: floor plane alone
  kFile,    ///< calibration_file, which must exist at the start
  kTf,      ///< somebody else publishes it: looked up for every cloud
};

/// Which frame is the parent on /tf_static.
enum class TfDirection {
  kCameraToBase,  ///< camera -> base: for cells where the camera already has a parent
  kBaseToCamera,  ///< base -> camera: for cells where the base frame already has a parent
};

struct DetectorOptions {
  std::string base_frame = "aruco_base";
  BaseSource base_source = BaseSource::kMarker;
  bool publish_tf = true;  ///< of a base frame that was calibrated or read from a file
  TfDirection tf_direction = TfDirection::kCameraToBase;
  std::string calibration_file;  ///< where a calibration is kept and found at the next start; empty: not kept
  int calibration_clouds = 3;    ///< clouds that one calibration averages
  bool calibrate_on_start = false;  ///< with the first clouds, when there is no calibration
  int queue_size = 1;               ///< clouds that wait while one is looked at; older ones are lost
  double cloud_timeout_s = 10.0;    ///< how long services wait for a cloud
  double tf_timeout_s = 0.2;        ///< how long a cloud waits for its transform with base_source tf
  std::string capture_service;      ///< of the camera, called when a service needs a cloud; empty: never
  detection::DetectionOptions detection;
};

/// Every broken rule as one line "key: what is wrong".
std::vector<std::string> problems(const DetectorOptions& options);

/// Reads a tree of parameters. Throws std::invalid_argument with everything that is wrong: unknown keys, wrong
/// types, broken rules.
DetectorOptions readDetectorOptions(const YAML::Node& tree);

}  // namespace mixed_palletizing::adapters

#include <algorithm>
#include <chrono>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <mixed_palletizing/adapters/calibration_file.hpp>
#include <mixed_palletizing/adapters/cloud_bag.hpp>
#include <mixed_palletizing/adapters/cloud_files.hpp>
#include <mixed_palletizing/adapters/cloud_message.hpp>
#include <mixed_palletizing/adapters/detection_options.hpp>
#include <mixed_palletizing/adapters/detector_options.hpp>
#include <mixed_palletizing/adapters/names.hpp>
#include <mixed_palletizing/adapters/offline_detection.hpp>
#include <mixed_palletizing/adapters/option_reader.hpp>
#include <mixed_palletizing/detection/box_detector.hpp>

namespace mixed_palletizing::adapters {
namespace {

sensor_msgs::PointCloud2ConstPtr fromFile(const std::string& path) {
  std_msgs::Header header;
  header.frame_id = names::kCameraFrame;
  return toMessage(readCloud(path), header);
}

sensor_msgs::PointCloud2ConstPtr firstOf(const std::string& bag, const std::string& topic) {
  sensor_msgs::PointCloud2ConstPtr first;
  readCloudBag(bag, topic, [&](const sensor_msgs::PointCloud2ConstPtr& message) {
    first = message;
    return false;
  });
  if (!first) throw std::runtime_error(bag + ": holds no cloud");
  return first;
}

geometry::CloudView checked(const sensor_msgs::PointCloud2& message, const std::string& origin) {
  const CheckedCloud cloud = checkCloud(message);
  if (!cloud.view) {
    throw std::runtime_error(origin + ": no usable cloud: " + toString(cloud.fault) + ": " + cloud.message);
  }
  return *cloud.view;
}

/// Detection part of a parameter file of the detector node; the defaults without a file.
detection::DetectionOptions optionsFrom(const std::string& path) {
  if (path.empty()) return detection::DetectionOptions();
  try {
    return readDetectorOptions(loadYaml(path)).detection;
  } catch (const std::invalid_argument& error) {
    // The list of mistakes in one line, as all errors of the tools.
    std::string text = error.what();
    for (std::size_t at = text.find("\n  "); at != std::string::npos; at = text.find("\n  ")) {
      text.replace(at, 3, at > 0 && text[at - 1] == ':' ? " " : "; ");
    }
    throw std::invalid_argument(path + ": " + text);
  }
}

detection::Method methodOf(const std::string& word) {
  for (const auto& method : detectionMethods()) {
    if (method.first == word) return method.second;
  }
  throw std::invalid_argument("method: '" + word + "' is neither 'best' nor 'thesis'");
}

detection::Mode modeOf(const std::string& word) {
  for (const auto& mode : detectionModes()) {
    if (mode.first == word) return mode.second;
  }
  throw std::invalid_argument("mode: '" + word + "' is neither 'palletize' nor 'depalletize'");
}

std::string describe(const detection::BaseFrame& frame, const std::string& origin) {
  std::ostringstream text;
  text << "base frame from " << origin << ": floor of " << frame.plane_inliers << " points, rms "
       << 1000.0 * frame.plane_rms_m << " mm";
  if (!frame.markers.empty()) text << ", marker " << frame.markers.front().id;
  return text.str();
}

void remove(const std::vector<geometry::Plane>& planes, detection::DetectionOptions& options) {
  options.region.planes.insert(options.region.planes.end(), planes.begin(), planes.end());
}

/// Fills base_from_camera and base of `result`.
void findBase(const OfflineDetectionRequest& request, const geometry::CloudView& cloud,
              const std::string& cloud_origin, detection::DetectionOptions& options,
              OfflineDetection& result) {
  if (request.base != "marker" && request.base != "floor") {
    if (!request.calibration_cloud.empty()) {
      throw std::invalid_argument("a calibration cloud needs the base 'marker' or 'floor', not a file");
    }
    if (!std::ifstream(request.base)) {
      throw std::invalid_argument("base: '" + request.base +
                                  "' is neither 'marker' nor 'floor' nor a file that can be read");
    }
    const Calibration calibration = readCalibration(request.base);
    result.base_from_camera = calibration.base_from_camera;
    remove(calibration.removed_planes, options);
    result.base = "base frame from " + request.base;
    return;
  }
  const auto source =
      request.base == "marker" ? detection::BaseFrameSource::kMarker : detection::BaseFrameSource::kFloor;
  sensor_msgs::PointCloud2ConstPtr message;
  geometry::CloudView view = cloud;
  std::string origin = cloud_origin;
  if (!request.calibration_cloud.empty()) {
    origin = request.calibration_cloud;
    message = fromFile(origin);
    view = checked(*message, origin);
  }
  const detection::BaseFrameResult found = detection::findBaseFrame(view, source, options);
  if (!found.frame) throw std::runtime_error(origin + ": no base frame: " + found.message);
  result.base_from_camera = found.frame->base_from_camera;
  remove(detection::removedPlanes(*found.frame, options.plane.remove), options);
  result.base = describe(*found.frame, origin);
}

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Detects `repeat` times; times are medians over the runs.
void detectRepeatedly(const sensor_msgs::PointCloud2& message, const std::string& origin, int repeat,
                      const detection::DetectionOptions& options, OfflineDetection& result) {
  detection::BoxDetector detector(options);
  std::vector<double> totals;
  std::vector<std::vector<double>> stages;
  for (int i = 0; i < repeat; ++i) {
    const auto start = std::chrono::steady_clock::now();
    result.detections = detector.detect(checked(message, origin), result.base_from_camera);
    const auto took = std::chrono::steady_clock::now() - start;
    totals.push_back(std::chrono::duration<double, std::milli>(took).count());
    const auto& times = result.detections.stage_times;
    stages.resize(times.size());
    for (std::size_t k = 0; k < times.size(); ++k) stages[k].push_back(times[k].milliseconds);
  }
  result.total_ms = medianOf(totals);
  for (std::size_t k = 0; k < stages.size(); ++k) {
    result.detections.stage_times[k].milliseconds = medianOf(stages[k]);
  }
}

}  // namespace

OfflineDetection detectOffline(const OfflineDetectionRequest& request) {
  if (request.cloud.empty() == request.bag.empty()) {
    throw std::invalid_argument("either a cloud file or a bag is needed");
  }
  if (!request.topic.empty() && request.bag.empty()) throw std::invalid_argument("a topic needs a bag");
  if (request.repeat < 1) {
    throw std::invalid_argument("repeat: " + std::to_string(request.repeat) + " is less than 1");
  }
  detection::DetectionOptions options = optionsFrom(request.params);
  if (!request.method.empty()) options.method = methodOf(request.method);
  if (!request.mode.empty()) options.mode = modeOf(request.mode);
  const std::string origin = request.bag.empty() ? request.cloud : request.bag;
  const sensor_msgs::PointCloud2ConstPtr message =
      request.bag.empty() ? fromFile(request.cloud) : firstOf(request.bag, request.topic);
  OfflineDetection result;
  findBase(request, checked(*message, origin), origin, options, result);
  detectRepeatedly(*message, origin, request.repeat, options, result);
  return result;
}

void replayOffline(const OfflineDetectionRequest& request,
                   const std::function<void(const ReplayedCloud&)>& use) {
  if (request.bag.empty()) throw std::invalid_argument("a bag is needed");
  detection::DetectionOptions options = optionsFrom(request.params);
  std::optional<detection::BoxDetector>
      detector;  // knows the planes that the first cloud's base frame removes
  ReplayedCloud cloud;
  bool has_base = false;
  readCloudBag(request.bag, request.topic, [&](const sensor_msgs::PointCloud2ConstPtr& message) {
    cloud.message = message;
    const CheckedCloud content = checkCloud(*message);
    cloud.fault = content.view ? "" : toString(content.fault);
    cloud.result.detections = detection::Detections();
    if (content.view) {
      if (!has_base) findBase(request, *content.view, request.bag, options, cloud.result);
      if (!has_base) detector.emplace(options);
      has_base = true;
      cloud.result.detections = detector->detect(*content.view, cloud.result.base_from_camera);
    }
    use(cloud);
    return true;
  });
  if (!has_base) throw std::runtime_error(request.bag + ": holds no usable cloud");
}

}  // namespace mixed_palletizing::adapters

// Boxes in one cloud.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include <mixed_palletizing/adapters/command_line.hpp>
#include <mixed_palletizing/adapters/detections_json.hpp>
#include <mixed_palletizing/adapters/offline_detection.hpp>

namespace adapters = mixed_palletizing::adapters;

namespace {

void write(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text << '\n';
  file.close();
  if (!file) throw std::runtime_error(path + ": cannot be written");
}

void print(const adapters::OfflineDetection& result) {
  std::cout << result.base << '\n';
  for (const auto& box : result.detections.boxes) {
    std::printf("box %.4f x %.4f x %.4f m, top at (%.4f, %.4f, %.4f) m, yaw %.2f deg", box.size.x(),
                box.size.y(), box.size.z(), box.top_center.x(), box.top_center.y(), box.top_center.z(),
                box.yaw_rad * 180.0 / M_PI);
    for (const std::string& flag : adapters::flagNames(box.flags)) std::printf(" %s", flag.c_str());
    std::printf("\n");
  }
  std::printf("%zu boxes, %zu clusters rejected, %.1f ms\n", result.detections.boxes.size(),
              result.detections.rejected.size(), result.total_ms);
}

}  // namespace

int main(int argc, char** argv) {
  adapters::OfflineDetectionRequest request;
  std::string json;
  adapters::CommandLine line("detect_boxes", "Finds the boxes in one organized cloud, as the nodelet does.");
  line.option("cloud", &request.cloud, "organized cloud, .pcd or .ply with a grid");
  line.option("bag", &request.bag, "instead of a file: bag whose first cloud is taken");
  line.option("topic", &request.topic, "of the bag; not needed when only one topic holds clouds");
  line.option("calibration-cloud", &request.calibration_cloud,
              "cloud in which the base frame is looked for, instead of the cloud itself");
  line.option("base", &request.base, "base frame: marker, floor, or a calibration file");
  line.option("params", &request.params, "parameter file of the detector node");
  line.option("mode", &request.mode, "palletize or depalletize, instead of what the parameter file says");
  line.option("method", &request.method, "best or thesis, instead of what the parameter file says");
  line.option("repeat", &request.repeat, "detections of the same cloud; times are medians");
  line.required("json", &json, "file to write");
  return line.run(argc, argv, [&] {
    const adapters::OfflineDetection result = adapters::detectOffline(request);
    write(json, adapters::detectionsJson(result.base_from_camera, result.detections, result.total_ms));
    print(result);
    return 0;
  });
}

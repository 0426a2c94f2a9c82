#include <cstring>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include <mixed_palletizing/adapters/captures/capture_files.hpp>
#include <mixed_palletizing/adapters/cloud_files.hpp>
#include <mixed_palletizing/adapters/names.hpp>
#include <mixed_palletizing/simulation/pinhole.hpp>
#include <mixed_palletizing/simulation/truth_json.hpp>

#include "whole_file.hpp"

namespace mixed_palletizing::captures {
namespace {

void requireEnding(const std::string& path, const std::string& ending) {
  const bool ends =
      path.size() > ending.size() && path.compare(path.size() - ending.size(), ending.size(), ending) == 0;
  if (!path.empty() && !ends) {
    throw std::invalid_argument("writeCaptureFiles: '" + path + "' does not end in " + ending);
  }
}

/// By way of memory: OpenCV does not notice when a disk is full.
void writeImage(const std::string& path, const std::string& ending, const cv::Mat& image) {
  std::vector<unsigned char> bytes;
  if (!cv::imencode(ending, image, bytes)) throw std::runtime_error(path + ": OpenCV cannot write " + ending);
  writeWholeFile(path, bytes.data(), bytes.size());
}

cv::Mat colorPicture(const geometry::OrganizedCloud& cloud) {
  cv::Mat picture(cloud.height, cloud.width, CV_8UC3);
  unsigned char* out = picture.data;
  for (const geometry::ColoredPoint& point : cloud.points) {
    *out++ = static_cast<unsigned char>(point.rgba);
    *out++ = static_cast<unsigned char>(point.rgba >> 8U);
    *out++ = static_cast<unsigned char>(point.rgba >> 16U);
  }
  return picture;
}

cv::Mat depthPicture(const geometry::OrganizedCloud& cloud) {
  cv::Mat picture(cloud.height, cloud.width, CV_32FC1);
  auto* out = picture.ptr<float>();
  for (const geometry::ColoredPoint& point : cloud.points) *out++ = point.z;
  return picture;
}

template <typename Numbers>
std::string matrixYaml(const std::string& name, int rows, int cols, const Numbers& numbers) {
  std::ostringstream text;
  text.precision(17);
  text << name << ":\n  rows: " << rows << "\n  cols: " << cols << "\n  data: [";
  for (std::size_t i = 0; i < numbers.size(); ++i) text << (i == 0 ? "" : ", ") << numbers[i];
  text << "]\n";
  return text.str();
}

}  // namespace

std::string cameraInfoYaml(const simulation::Camera& camera) {
  const simulation::Pinhole pinhole(camera);
  using Numbers = std::vector<double>;
  return "image_width: " + std::to_string(camera.width_px) +
         "\nimage_height: " + std::to_string(camera.height_px) +
         "\ncamera_name: " + adapters::names::kCameraFrame + "\n" +
         matrixYaml("camera_matrix", 3, 3,
                    Numbers{pinhole.fx_px, 0, pinhole.cx_px, 0, pinhole.fy_px, pinhole.cy_px, 0, 0, 1}) +
         "distortion_model: plumb_bob\n" +
         matrixYaml("distortion_coefficients", 1, 5, Numbers{0, 0, 0, 0, 0}) +
         matrixYaml("rectification_matrix", 3, 3, Numbers{1, 0, 0, 0, 1, 0, 0, 0, 1}) +
         matrixYaml(
             "projection_matrix", 3, 4,
             Numbers{pinhole.fx_px, 0, pinhole.cx_px, 0, 0, pinhole.fy_px, pinhole.cy_px, 0, 0, 0, 1, 0});
}

void writeCaptureFiles(const CaptureFiles& files, const simulation::Scene& scene,
                       const simulation::Capture& capture, std::uint64_t seed) {
  requireEnding(files.color, ".png");
  requireEnding(files.depth, ".tiff");
  requireEnding(files.mask, ".png");
  requireEnding(files.camera_info, ".yaml");
  requireEnding(files.bag, ".bag");
  if (!files.cloud.empty()) {
    adapters::writeCloud(files.cloud, capture.cloud,
                         files.layout.value_or(adapters::CloudLayout::kXyzrgbaUint32));
  }
  if (!files.color.empty()) writeImage(files.color, ".png", colorPicture(capture.cloud));
  if (!files.depth.empty()) writeImage(files.depth, ".tiff", depthPicture(capture.cloud));
  if (!files.mask.empty()) {
    cv::Mat mask(capture.cloud.height, capture.cloud.width, CV_16UC1);
    std::memcpy(mask.data, capture.mask.data(), capture.mask.size() * sizeof(std::uint16_t));
    writeImage(files.mask, ".png", mask);
  }
  if (!files.camera_info.empty()) writeWholeFile(files.camera_info, cameraInfoYaml(scene.camera));
  if (!files.truth.empty()) writeWholeFile(files.truth, simulation::truthJson(scene, capture, seed));
  if (!files.bag.empty()) {
    const adapters::CloudLayout layout = files.layout.value_or(adapters::CloudLayout::kXyzrgbaFloat32);
    writeCaptureBag(files.bag, scene, capture, layout, files.bag_stamp_s);
  }
}

}  // namespace mixed_palletizing::captures

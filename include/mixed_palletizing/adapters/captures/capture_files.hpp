// Everything that a simulated capture is written as: cloud, images, calibration, truth, bag.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <mixed_palletizing/adapters/cloud_layout.hpp>
#include <mixed_palletizing/simulation/capture.hpp>
#include <mixed_palletizing/simulation/scene.hpp>

namespace mixed_palletizing::captures {

/// Files of one capture; what has no path is not written.
struct CaptureFiles {
  std::string cloud;        ///< .pcd or .ply
  std::string color;        ///< .png, 8 bits a channel
  std::string depth;        ///< .tiff, float32: z [m], NaN without data
  std::string mask;         ///< .png, 16 bits: 0 = no box, i + 1 = box i
  std::string camera_info;  ///< .yaml as camera_calibration_parsers reads it
  std::string truth;        ///< .json, see simulation/truth_json.hpp
  std::string bag;          ///< .bag, see writeCaptureBag()
  /// Of the cloud in file and bag; absent: xyzrgba_uint32 in the file, xyzrgba_float32 in the bag, as the driver's.
  std::optional<adapters::CloudLayout> layout;
  double bag_stamp_s = 1.0;  ///< ROS time of the capture in the bag
};

/// Writes the files. Throws std::invalid_argument for wrong endings (before anything is written), std::runtime_error
/// "PATH: reason" when one cannot be written whole.
void writeCaptureFiles(const CaptureFiles& files, const simulation::Scene& scene,
                       const simulation::Capture& capture, std::uint64_t seed);

/// A bag as recorded from the driver (namespace /zivid_camera): points/xyzrgba (with the layout xyz: points/xyz),
/// color/image_color, depth/image and their camera_info; and /tf_static with the true pose of the camera,
/// `world` -> zivid_optical_frame. Everything is stamped and recorded at stamp_s. Throws std::runtime_error
/// "PATH: reason".
void writeCaptureBag(const std::string& path, const simulation::Scene& scene,
                     const simulation::Capture& capture, adapters::CloudLayout layout, double stamp_s);

/// Text of a camera_info file: pinhole without distortion.
std::string cameraInfoYaml(const simulation::Camera& camera);

}  // namespace mixed_palletizing::captures

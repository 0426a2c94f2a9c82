// The images that the camera driver publishes beside its clouds.
#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <mixed_palletizing/geometry/organized_cloud.hpp>
#include <mixed_palletizing/simulation/scene.hpp>

namespace mixed_palletizing::captures {

/// rgba8, alpha 255.
sensor_msgs::ImagePtr colorImage(const geometry::OrganizedCloud& cloud, const std_msgs::Header& header);

/// 32FC1: z [m], NaN without data.
sensor_msgs::ImagePtr depthImage(const geometry::OrganizedCloud& cloud, const std_msgs::Header& header);

/// Pinhole without distortion.
sensor_msgs::CameraInfoPtr cameraInfo(const simulation::Camera& camera, const std_msgs::Header& header);

}  // namespace mixed_palletizing::captures

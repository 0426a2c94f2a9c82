#include <geometry_msgs/TransformStamped.h>
#include <tf2_msgs/TFMessage.h>

#include <mixed_palletizing/adapters/camera_images.hpp>
#include <mixed_palletizing/adapters/capture_files.hpp>
#include <mixed_palletizing/adapters/cloud_message.hpp>
#include <mixed_palletizing/adapters/names.hpp>

#include "bag_writer.hpp"
#include "message_parts.hpp"

namespace mixed_palletizing::adapters {
namespace {

constexpr char kCameraNamespace[] = "/zivid_camera/";
constexpr char kWorldFrame[] = "world";

tf2_msgs::TFMessage cameraTransform(const geometry::Pose& world_from_camera, const std_msgs::Header& header) {
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = header.stamp;
  transform.header.frame_id = kWorldFrame;
  transform.child_frame_id = header.frame_id;
  const geometry_msgs::Pose pose = poseMessage(world_from_camera);
  transform.transform.translation.x = pose.position.x;
  transform.transform.translation.y = pose.position.y;
  transform.transform.translation.z = pose.position.z;
  transform.transform.rotation = pose.orientation;
  tf2_msgs::TFMessage message;
  message.transforms.push_back(transform);
  return message;
}

}  // namespace

void writeCaptureBag(const std::string& path, const simulation::Scene& scene,
                     const simulation::Capture& capture, CloudLayout layout, double stamp_s) {
  std_msgs::Header header;
  header.frame_id = names::kCameraFrame;
  header.stamp.fromSec(stamp_s);
  const std::string camera = kCameraNamespace;
  const char* points = layout == CloudLayout::kXyz ? names::kPointsXyz : names::kPointsXyzrgba;
  BagWriter bag(path);
  bag.write("/tf_static", header.stamp, cameraTransform(scene.camera.world_from_camera, header));
  bag.write(camera + points, header.stamp, toMessage(capture.cloud, header, layout));
  bag.write(camera + names::kColorImage, header.stamp, colorImage(capture.cloud, header));
  bag.write(camera + names::kColorInfo, header.stamp, cameraInfo(scene.camera, header));
  bag.write(camera + names::kDepthImage, header.stamp, depthImage(capture.cloud, header));
  bag.write(camera + names::kDepthInfo, header.stamp, cameraInfo(scene.camera, header));
  bag.close();
}

}  // namespace mixed_palletizing::adapters

#include <geometry_msgs/TransformStamped.h>
#include <tf2_msgs/TFMessage.h>

#include <mixed_palletizing/adapters/bag_writer.hpp>
#include <mixed_palletizing/adapters/captures/camera_images.hpp>
#include <mixed_palletizing/adapters/captures/capture_files.hpp>
#include <mixed_palletizing/adapters/cloud_message.hpp>
#include <mixed_palletizing/adapters/message_parts.hpp>
#include <mixed_palletizing/adapters/names.hpp>

namespace mixed_palletizing::captures {
namespace {

constexpr char kCameraNamespace[] = "/zivid_camera/";
constexpr char kWorldFrame[] = "world";

tf2_msgs::TFMessage cameraTransform(const geometry::Pose& world_from_camera, const std_msgs::Header& header) {
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = header.stamp;
  transform.header.frame_id = kWorldFrame;
  transform.child_frame_id = header.frame_id;
  const geometry_msgs::Pose pose = adapters::poseMessage(world_from_camera);
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
                     const simulation::Capture& capture, adapters::CloudLayout layout, double stamp_s) {
  std_msgs::Header header;
  header.frame_id = adapters::names::kCameraFrame;
  header.stamp.fromSec(stamp_s);
  const std::string camera = kCameraNamespace;
  const char* points =
      layout == adapters::CloudLayout::kXyz ? adapters::names::kPointsXyz : adapters::names::kPointsXyzrgba;
  adapters::BagWriter bag(path);
  bag.write("/tf_static", header.stamp, cameraTransform(scene.camera.world_from_camera, header));
  bag.write(camera + points, header.stamp, adapters::toMessage(capture.cloud, header, layout));
  bag.write(camera + adapters::names::kColorImage, header.stamp, colorImage(capture.cloud, header));
  bag.write(camera + adapters::names::kColorInfo, header.stamp, cameraInfo(scene.camera, header));
  bag.write(camera + adapters::names::kDepthImage, header.stamp, depthImage(capture.cloud, header));
  bag.write(camera + adapters::names::kDepthInfo, header.stamp, cameraInfo(scene.camera, header));
  bag.close();
}

}  // namespace mixed_palletizing::captures

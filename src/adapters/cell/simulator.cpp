#include <random>
#include <stdexcept>

#include <geometry_msgs/PointStamped.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include <mixed_palletizing/adapters/captures/camera_images.hpp>
#include <mixed_palletizing/adapters/cell/simulator.hpp>
#include <mixed_palletizing/adapters/cloud_message.hpp>
#include <mixed_palletizing/adapters/message_parts.hpp>
#include <mixed_palletizing/adapters/parameters.hpp>
#include <mixed_palletizing/adapters/transform_lookup.hpp>
#include <mixed_palletizing/geometry/rectangle.hpp>
#include <mixed_palletizing/simulation/capture.hpp>

namespace mixed_palletizing::cell {
namespace {

/// Seeds of the boxes' places and of the sensor's noise, apart from each other and from that of the order.
enum class SeedOf : std::uint32_t { kPlaces = 1, kNoise = 2 };

std::uint64_t derivedSeed(std::uint64_t seed, SeedOf what, std::uint64_t count) {
  std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U),
                         static_cast<std::uint32_t>(what), static_cast<std::uint32_t>(count)};
  return std::mt19937_64(sequence)();
}

/// What a perfect detector would say.
Box trueBox(const simulation::SceneBox& solid, std::size_t id) {
  const geometry::Rectangle footprint =
      geometry::Rectangle{solid.position_m, solid.yaw_rad, solid.size_m.head<2>()}.lengthFirst();
  const double height = solid.size_m.z();
  const Eigen::Vector3d top(solid.position_m.x(), solid.position_m.y(), solid.base_z_m + height);
  Box box;
  box.id = static_cast<std::uint32_t>(id);
  box.pose.pose = adapters::poseMessage(
      geometry::poseFromYaw(top - Eigen::Vector3d(0, 0, 0.5 * height), footprint.yaw_rad));
  box.size = adapters::vectorMessage({footprint.size.x(), footprint.size.y(), height});
  box.top_center = adapters::pointMessage(top);
  box.top_normal.z = 1.0;
  box.top_visibility = 1.0;
  return box;
}

}  // namespace

CellSimulator::CellSimulator(const ros::NodeHandle& node, const ros::NodeHandle& private_node)
    : options_(readCellSimulatorOptions(adapters::parameterTree(private_node))),
      cloud_layout_(adapters::cloudLayout(options_.cloud_layout)),
      instance_(cellOrder(options_.order)),
      scene_(cellScene(options_)),
      area_(instance_, options_.n_pick, CellLayout(scene_, options_.layout),
            derivedSeed(options_.order.seed, SeedOf::kPlaces, 0)),
      node_(node),
      listener_(transforms_) {
  if (node_.getNamespace() == "/") {
    throw std::invalid_argument(
        "the camera's topics need a namespace: ROS_NAMESPACE=zivid_camera, or ns= in a "
        "launch file");
  }
  points_xyz_ = node_.advertise<sensor_msgs::PointCloud2>(adapters::names::kPointsXyz, 1);
  points_xyzrgba_ = node_.advertise<sensor_msgs::PointCloud2>(adapters::names::kPointsXyzrgba, 1);
  color_image_ = node_.advertise<sensor_msgs::Image>(adapters::names::kColorImage, 1);
  color_info_ = node_.advertise<sensor_msgs::CameraInfo>(adapters::names::kColorInfo, 1);
  depth_image_ = node_.advertise<sensor_msgs::Image>(adapters::names::kDepthImage, 1);
  depth_info_ = node_.advertise<sensor_msgs::CameraInfo>(adapters::names::kDepthInfo, 1);
  truth_ = node_.advertise<BoxArray>(adapters::names::kTruth, 1, true);
  publishTruth();
  capture_service_ = node_.advertiseService(adapters::names::kCapture, &CellSimulator::onCapture, this);
  take_service_ = node_.advertiseService(adapters::names::kTakeBox, &CellSimulator::onTake, this);
  ROS_INFO("order %s: %d boxes, %zu of them in the pick area", instance_.name.c_str(),
           instance_.order.itemCount(), area_.boxes().size());
}

bool CellSimulator::onCapture(std_srvs::EmptyRequest& /*request*/, std_srvs::EmptyResponse& /*response*/) {
  const std::lock_guard<std::mutex> lock(mutex_);
  try {
    capture();
    return true;
  } catch (const std::exception& error) {
    ROS_ERROR("capture: %s", error.what());
    return false;
  }
}

bool CellSimulator::listened() const {
  for (const ros::Publisher* publisher :
       {&points_xyz_, &points_xyzrgba_, &color_image_, &color_info_, &depth_image_, &depth_info_}) {
    if (publisher->getNumSubscribers() > 0) return true;
  }
  return false;
}

void CellSimulator::capture() {
  if (!listened()) return;
  scene_.boxes.clear();
  for (const PickAreaBox& box : area_.boxes()) scene_.boxes.push_back(box.solid);
  const std::uint64_t seed = derivedSeed(options_.order.seed, SeedOf::kNoise, captures_++);
  const simulation::Capture captured = simulation::capture(scene_, seed, options_.threads);
  const geometry::OrganizedCloud& cloud = captured.cloud;
  std_msgs::Header header;
  header.stamp = ros::Time::now();
  header.frame_id = options_.frame_id;

  if (points_xyzrgba_.getNumSubscribers() > 0)
    points_xyzrgba_.publish(adapters::toMessage(cloud, header, cloud_layout_));
  if (color_image_.getNumSubscribers() > 0) color_image_.publish(captures::colorImage(cloud, header));
  if (depth_image_.getNumSubscribers() > 0) depth_image_.publish(captures::depthImage(cloud, header));
  if (color_info_.getNumSubscribers() > 0) color_info_.publish(captures::cameraInfo(scene_.camera, header));
  if (depth_info_.getNumSubscribers() > 0) depth_info_.publish(captures::cameraInfo(scene_.camera, header));
  if (points_xyz_.getNumSubscribers() > 0) {
    points_xyz_.publish(adapters::toMessage(cloud, header, adapters::CloudLayout::kXyz));
  }
}

bool CellSimulator::onTake(TakeBoxRequest& request, TakeBoxResponse& response) {
  const std::lock_guard<std::mutex> lock(mutex_);
  try {
    take(request, response);
  } catch (const std::exception& error) {
    response = TakeBoxResponse();
    response.message = error.what();
    ROS_WARN("take_box: %s", error.what());
  }
  response.visible = static_cast<std::uint32_t>(area_.boxes().size());
  response.waiting = static_cast<std::uint32_t>(area_.waiting());
  return true;
}

void CellSimulator::take(const TakeBoxRequest& request, TakeBoxResponse& response) {
  const adapters::FoundTransform camera_from_frame = adapters::lookUpTransform(
      transforms_, options_.frame_id, request.point.header.frame_id, ros::Time(0), options_.tf_timeout_s);
  if (!camera_from_frame.transform) throw std::runtime_error(camera_from_frame.problem);
  geometry_msgs::PointStamped point;
  tf2::doTransform(request.point, point, *camera_from_frame.transform);
  const Eigen::Vector3d in_world = scene_.camera.world_from_camera * adapters::toEigen(point.point);
  const auto index = area_.find(in_world, options_.take_tolerance_m);
  if (!index) {
    std::ostringstream text;
    text << "there is no box at (" << in_world.transpose() << ") m from the marker";
    throw std::runtime_error(text.str());
  }
  const PickAreaBox taken = area_.take(*index, request.discard);
  publishTruth();
  response.success = true;
  response.type_id = taken.solid.name;
  response.item = static_cast<std::uint32_t>(taken.item);
  response.message = (request.discard ? "threw out " : "took ") + taken.solid.name;
}

void CellSimulator::publishTruth() {
  auto truth = boost::make_shared<BoxArray>();
  truth->header.stamp = ros::Time::now();
  truth->header.frame_id = options_.base_frame;
  for (const PickAreaBox& box : area_.boxes())
    truth->boxes.push_back(trueBox(box.solid, truth->boxes.size()));
  truth_.publish(truth);
}

}  // namespace mixed_palletizing::cell

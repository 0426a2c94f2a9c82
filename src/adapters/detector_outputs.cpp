#include "detector_outputs.hpp"

#include <algorithm>
#include <array>

#include <boost/make_shared.hpp>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl_conversions/pcl_conversions.h>
#include <pcl_ros/point_cloud.h>
#include <sensor_msgs/Image.h>
#include <visualization_msgs/MarkerArray.h>

#include <mixed_palletizing/adapters/box_messages.hpp>
#include <mixed_palletizing/adapters/markers.hpp>
#include <mixed_palletizing/adapters/names.hpp>
#include <mixed_palletizing/adapters/parameters.hpp>

namespace mixed_palletizing::adapters {
namespace {

/// Detections::stage_pixels by name.
constexpr std::array<const char*, 4> kStages{"floor", "clusters", "tops", "edges"};

using StageCloud = pcl::PointCloud<pcl::PointXYZRGB>;

/// The points one stage kept, unorganized, in the camera's frame.
boost::shared_ptr<StageCloud> stageCloud(const AcceptedCloud& cloud,
                                         const std::vector<std::uint32_t>& pixels) {
  auto points = boost::make_shared<StageCloud>();
  pcl_conversions::toPCL(cloud.message->header, points->header);
  points->reserve(pixels.size());
  const auto width = static_cast<std::uint32_t>(cloud.view.width);
  for (const std::uint32_t pixel : pixels) {
    const int row = static_cast<int>(pixel / width);
    const int col = static_cast<int>(pixel % width);
    const Eigen::Vector3f p = cloud.view.point(row, col);
    pcl::PointXYZRGB point;
    point.x = p.x();
    point.y = p.y();
    point.z = p.z();
    if (cloud.view.hasColor()) {
      const std::uint8_t* bgr = cloud.view.bgr(row, col);
      point.b = bgr[0];
      point.g = bgr[1];
      point.r = bgr[2];
    }
    points->push_back(point);
  }
  return points;
}

bool listenedTo(const ros::Publisher& publisher) { return publisher.getNumSubscribers() > 0; }

}  // namespace

DetectorOutputs::DetectorOutputs(ros::NodeHandle& private_node)
    : boxes_(private_node.advertise<BoxArray>(siblingName(private_node, names::kBoxes), 10)),
      markers_(private_node.advertise<visualization_msgs::MarkerArray>(
          siblingName(private_node, names::kMarkers), 1, true)),
      labels_(private_node.advertise<sensor_msgs::Image>(siblingName(private_node, names::kLabels), 2)) {
  for (const char* stage : kStages) {
    stages_[stage] = private_node.advertise<StageCloud>(std::string(names::kDebugPrefix) + stage, 1);
  }
}

bool DetectorOutputs::wanted() const {
  return listenedTo(boxes_) || listenedTo(markers_) || listenedTo(labels_) || stagesWanted();
}

bool DetectorOutputs::stagesWanted() const {
  return std::any_of(stages_.begin(), stages_.end(),
                     [](const auto& stage) { return listenedTo(stage.second); });
}

void DetectorOutputs::publish(const AcceptedCloud& cloud, const detection::Detections& detections,
                              const BoxArrayConstPtr& boxes) {
  boxes_.publish(boxes);
  if (listenedTo(markers_)) markers_.publish(boxMarkers(*boxes));
  if (listenedTo(labels_)) labels_.publish(labelImage(detections, cloud.message->header));
  publishStages(cloud, detections);
}

void DetectorOutputs::publishStages(const AcceptedCloud& cloud, const detection::Detections& detections) {
  for (const detection::StagePixels& stage : detections.stage_pixels) {
    const auto publisher = stages_.find(stage.stage);
    if (publisher == stages_.end() || !listenedTo(publisher->second)) continue;
    publisher->second.publish(stageCloud(cloud, stage.pixels));
  }
}

}  // namespace mixed_palletizing::adapters

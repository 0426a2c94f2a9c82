// The source thesis' chain as one would write it with PCL (3.2.1 "Transformation", 3.2.2): the measure for the speed.
#pragma once

#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include <Eigen/Core>
#include <pcl/common/transforms.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/euclidean_cluster_comparator.h>
#include <pcl/segmentation/organized_connected_component_segmentation.h>
#include <pcl/surface/convex_hull.h>

#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::bench {

/// Transform the whole cloud, take the floor away, connected components, hull of each top.
class PclThesis {
 public:
  using Point = pcl::PointXYZRGB;

  explicit PclThesis(const geometry::Pose& base_from_camera) : base_from_camera_(base_from_camera) {}

  void transform(const pcl::PointCloud<Point>& cloud) {
    cloud_.reset(new pcl::PointCloud<Point>);
    pcl::transformPointCloud(cloud, *cloud_, base_from_camera_.matrix().cast<float>());
  }

  /// Components above the floor with at least kMinPoints points.
  std::vector<pcl::PointIndices> clusters() const {
    pcl::PointCloud<pcl::Label>::Ptr labels(new pcl::PointCloud<pcl::Label>);
    labels->width = cloud_->width;
    labels->height = cloud_->height;
    labels->resize(cloud_->size());
    for (std::size_t i = 0; i < cloud_->size(); ++i) {
      labels->points[i].label = cloud_->points[i].z > kFloor ? 1 : 0;  // not a number: the floor's
    }
    using Comparator = pcl::EuclideanClusterComparator<Point, pcl::Label>;
    Comparator::Ptr comparator(new Comparator);
    typename Comparator::ExcludeLabelSetPtr excluded(new Comparator::ExcludeLabelSet);
    excluded->insert(1);  // in spite of its name, PCL joins the points whose labels are in it
    comparator->setInputCloud(cloud_);
    comparator->setLabels(labels);
    comparator->setExcludeLabels(excluded);
    comparator->setDistanceThreshold(kDistance, false);
    pcl::OrganizedConnectedComponentSegmentation<Point, pcl::Label> segmentation(comparator);
    segmentation.setInputCloud(cloud_);
    pcl::PointCloud<pcl::Label> result;
    std::vector<pcl::PointIndices> all;
    segmentation.segment(result, all);
    std::vector<pcl::PointIndices> kept;
    for (pcl::PointIndices& cluster : all) {
      if (cluster.indices.size() >= kMinPoints &&
          cloud_->points[static_cast<std::size_t>(cluster.indices[0])].z > kFloor) {
        kept.push_back(std::move(cluster));
      }
    }
    return kept;
  }

  /// Convex hull of the points near the top of each cluster; returns the number of hulls.
  std::size_t hulls(const std::vector<pcl::PointIndices>& clusters) const {
    std::size_t count = 0;
    for (const pcl::PointIndices& cluster : clusters) {
      float top = 0.0f;
      for (const auto i : cluster.indices) top = std::max(top, cloud_->points[static_cast<std::size_t>(i)].z);
      pcl::PointCloud<Point>::Ptr face(new pcl::PointCloud<Point>);
      for (const auto i : cluster.indices) {
        const Point& p = cloud_->points[static_cast<std::size_t>(i)];
        if (p.z > top - kTopDepth) face->push_back(p);
      }
      for (Point& p : face->points) p.z = 0.0f;
      pcl::ConvexHull<Point> hull;
      hull.setInputCloud(face);
      hull.setDimension(2);
      pcl::PointCloud<Point> corners;
      hull.reconstruct(corners);
      count += corners.size() >= 3 ? 1 : 0;
    }
    return count;
  }

 private:
  static constexpr float kFloor = 0.02f;      // [m]
  static constexpr float kDistance = 0.005f;  // [m]
  static constexpr float kTopDepth = 0.01f;   // [m]
  static constexpr std::size_t kMinPoints = 400;

  geometry::Pose base_from_camera_;
  pcl::PointCloud<Point>::Ptr cloud_;
};

}  // namespace mixed_palletizing::bench

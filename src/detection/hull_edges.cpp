#include "hull_edges.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/surface/convex_hull.h>

#include "quiet_pcl.hpp"

namespace mixed_palletizing::detection {
namespace {

/// Angle between two vectors [rad], 0 to pi.
double angleBetween(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
}

/// True when all points lie within a hair of one line: Quickhull needs a plane.
bool onOneLine(const std::vector<Eigen::Vector2d>& points) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& p : points) mean += p;
  mean /= static_cast<double>(points.size());
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector2d& p : points) squares += (p - mean) * (p - mean).transpose();
  return !(squares.determinant() > 1e-8 * squares.trace() * squares.trace());
}

}  // namespace

geometry::Polygon convexHull(const std::vector<Eigen::Vector2d>& points) {
  if (points.size() < 3 || onOneLine(points)) return {};
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  cloud->reserve(points.size());
  for (const Eigen::Vector2d& p : points) {
    cloud->push_back(pcl::PointXYZ(static_cast<float>(p.x()), static_cast<float>(p.y()), 0.0f));
  }
  // All points: left to find that out, PCL answers with an empty hull when memory runs out.
  const pcl::IndicesPtr all(new pcl::IndicesPtr::element_type(points.size()));
  std::iota(all->begin(), all->end(), 0);
  const QuietPcl quiet;
  static std::mutex qhull_mutex;  // PCL 1.10 calls the qhull that has its state in global variables
  const std::lock_guard<std::mutex> lock(qhull_mutex);
  pcl::ConvexHull<pcl::PointXYZ> quickhull;
  quickhull.setInputCloud(cloud);
  quickhull.setIndices(all);
  quickhull.setDimension(2);
  pcl::PointCloud<pcl::PointXYZ> corners;
  quickhull.reconstruct(corners);
  geometry::Polygon hull;
  for (const pcl::PointXYZ& p : corners) hull.emplace_back(p.x, p.y);
  if (geometry::signedArea(hull) < 0.0) std::reverse(hull.begin(), hull.end());
  return hull;
}

std::vector<Edge> findEdges(const geometry::Polygon& hull, double min_length_m, const TopOptions& options) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Edge vector{hull[i], hull[(i + 1) % hull.size()]};  // line 3
    if (vector.length() <= min_length_m) continue;            // line 4
    if (edges.empty()) {                                      // lines 11, 12
      edges.push_back(vector);
      continue;
    }
    const double angle = angleBetween(vector.along(), edges.back().along());  // line 6
    if (angle > options.new_edge_angle_rad) {                                 // lines 7, 8
      edges.push_back(vector);
    } else if (angle < options.merge_angle_rad) {  // lines 9, 10
      edges.back().to = vector.to;
    }
  }
  if (edges.size() > 1 &&
      angleBetween(edges.back().along(), edges.front().along()) < options.merge_angle_rad) {
    edges.front().from = edges.back().from;
    edges.pop_back();
  }
  return edges;
}

}  // namespace mixed_palletizing::detection

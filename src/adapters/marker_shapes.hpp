// Parts of visualization messages: always a unit quaternion, a positive scale and a lifetime of forever.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <std_msgs/ColorRGBA.h>
#include <visualization_msgs/Marker.h>
#include <visualization_msgs/MarkerArray.h>

#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::adapters {

/// Collects markers of one frame and stamp. Starts with DELETEALL, so that what is not repeated vanishes; ids
/// count from 0 in every namespace, so that they are the same for the same picture. Shapes with a coordinate
/// that is not finite are left out.
class MarkerSet {
 public:
  explicit MarkerSet(const std_msgs::Header& header);

  /// Solid cuboid around its centre.
  void cuboid(const std::string& ns, const geometry::Pose& center, const Eigen::Vector3d& size,
              const std_msgs::ColorRGBA& color);

  /// Its twelve edges.
  void edges(const std::string& ns, const geometry::Pose& center, const Eigen::Vector3d& size,
             double line_width, const std_msgs::ColorRGBA& color);

  /// Text that faces the viewer; `height` is that of a capital letter.
  void text(const std::string& ns, const Eigen::Vector3d& position, double height, const std::string& words,
            const std_msgs::ColorRGBA& color);

  void arrow(const std::string& ns, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
             double shaft_diameter, const std_msgs::ColorRGBA& color);

  void sphere(const std::string& ns, const Eigen::Vector3d& center, double diameter,
              const std_msgs::ColorRGBA& color);

  visualization_msgs::MarkerArrayPtr take() { return markers_; }

 private:
  visualization_msgs::Marker& add(const std::string& ns, int type, const std_msgs::ColorRGBA& color);

  std_msgs::Header header_;
  visualization_msgs::MarkerArrayPtr markers_;
};

/// Colour from 0xRRGGBB and opacity.
std_msgs::ColorRGBA color(std::uint32_t rgb, float alpha = 1.0f);

/// One of a dozen colours that can be told apart, the same for the same index.
std_msgs::ColorRGBA paletteColor(std::size_t index, float alpha = 1.0f);

}  // namespace mixed_palletizing::adapters

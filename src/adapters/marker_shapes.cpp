#include "marker_shapes.hpp"

#include <algorithm>
#include <array>

#include <boost/make_shared.hpp>

#include <mixed_palletizing/adapters/message_parts.hpp>

namespace mixed_palletizing::adapters {
namespace {

using visualization_msgs::Marker;

constexpr double kSmallestScaleM = 1e-4;  // rviz warns about scales of 0

/// The twelve edges of a unit cube as pairs of corners; bit i of a corner is its side on axis i.
constexpr std::array<std::array<int, 2>, 12> kCubeEdges{
    {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

Eigen::Vector3d corner(int index, const Eigen::Vector3d& size) {
  return {((index & 1) != 0 ? 0.5 : -0.5) * size.x(), ((index & 2) != 0 ? 0.5 : -0.5) * size.y(),
          ((index & 4) != 0 ? 0.5 : -0.5) * size.z()};
}

Eigen::Vector3d positive(const Eigen::Vector3d& scale) { return scale.cwiseMax(kSmallestScaleM); }

bool usable(const geometry::Pose& pose, const Eigen::Vector3d& size) {
  return pose.matrix().allFinite() && size.allFinite();
}

}  // namespace

MarkerSet::MarkerSet(const std_msgs::Header& header)
    : header_(header), markers_(boost::make_shared<visualization_msgs::MarkerArray>()) {
  Marker clear;
  clear.header = header_;
  clear.action = Marker::DELETEALL;
  clear.pose.orientation.w = 1.0;
  markers_->markers.push_back(clear);
}

Marker& MarkerSet::add(const std::string& ns, int type, const std_msgs::ColorRGBA& color) {
  const auto same = std::count_if(markers_->markers.begin(), markers_->markers.end(),
                                  [&](const Marker& marker) { return marker.ns == ns; });
  Marker marker;
  marker.header = header_;
  marker.ns = ns;
  marker.id = static_cast<std::int32_t>(same);
  marker.type = type;
  marker.action = Marker::ADD;
  marker.color = color;
  marker.pose.orientation.w = 1.0;
  markers_->markers.push_back(marker);
  return markers_->markers.back();
}

void MarkerSet::cuboid(const std::string& ns, const geometry::Pose& center, const Eigen::Vector3d& size,
                       const std_msgs::ColorRGBA& color) {
  if (!usable(center, size)) return;
  Marker& marker = add(ns, Marker::CUBE, color);
  marker.pose = poseMessage(center);
  marker.scale = vectorMessage(positive(size));
}

void MarkerSet::edges(const std::string& ns, const geometry::Pose& center, const Eigen::Vector3d& size,
                      double line_width, const std_msgs::ColorRGBA& color) {
  if (!usable(center, size)) return;
  Marker& marker = add(ns, Marker::LINE_LIST, color);
  marker.pose = poseMessage(center);
  marker.scale.x = line_width;
  for (const auto& edge : kCubeEdges) {
    for (const int end : edge) marker.points.push_back(pointMessage(corner(end, size)));
  }
}

void MarkerSet::text(const std::string& ns, const Eigen::Vector3d& position, double height,
                     const std::string& words, const std_msgs::ColorRGBA& color) {
  if (!position.allFinite() || words.empty()) return;
  Marker& marker = add(ns, Marker::TEXT_VIEW_FACING, color);
  marker.pose.position = pointMessage(position);
  marker.scale.z = height;
  marker.text = words;
}

void MarkerSet::arrow(const std::string& ns, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                      double shaft_diameter, const std_msgs::ColorRGBA& color) {
  if (!from.allFinite() || !to.allFinite()) return;
  Marker& marker = add(ns, Marker::ARROW, color);
  marker.scale.x = shaft_diameter;
  marker.scale.y = 2.5 * shaft_diameter;
  marker.scale.z = 3.0 * shaft_diameter;
  marker.points = {pointMessage(from), pointMessage(to)};
}

void MarkerSet::sphere(const std::string& ns, const Eigen::Vector3d& center, double diameter,
                       const std_msgs::ColorRGBA& color) {
  if (!center.allFinite()) return;
  Marker& marker = add(ns, Marker::SPHERE, color);
  marker.pose.position = pointMessage(center);
  marker.scale = vectorMessage(positive(Eigen::Vector3d::Constant(diameter)));
}

std_msgs::ColorRGBA color(std::uint32_t rgb, float alpha) {
  std_msgs::ColorRGBA message;
  message.r = static_cast<float>((rgb >> 16) & 0xffu) / 255.0f;
  message.g = static_cast<float>((rgb >> 8) & 0xffu) / 255.0f;
  message.b = static_cast<float>(rgb & 0xffu) / 255.0f;
  message.a = alpha;
  return message;
}

std_msgs::ColorRGBA paletteColor(std::size_t index, float alpha) {
  // Paul Tol's "muted" and "bright" schemes: distinct also for colour-blind viewers.
  constexpr std::array<std::uint32_t, 12> kPalette{0x4477aa, 0xee6677, 0x228833, 0xccbb44,
                                                   0x66ccee, 0xaa3377, 0xddcc77, 0x88ccee,
                                                   0xcc6677, 0x44aa99, 0x999933, 0x882255};
  return color(kPalette[index % kPalette.size()], alpha);
}

}  // namespace mixed_palletizing::adapters

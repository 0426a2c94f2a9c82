#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <mixed_palletizing/RejectedCluster.h>
#include <mixed_palletizing/adapters/markers.hpp>

namespace mixed_palletizing::adapters {
namespace {

using visualization_msgs::Marker;

/// What rviz complains about, and what would leave old markers behind.
void expectSound(const visualization_msgs::MarkerArray& array, const std::string& frame) {
  ASSERT_FALSE(array.markers.empty());
  EXPECT_EQ(array.markers.front().action, Marker::DELETEALL);
  std::set<std::pair<std::string, int>> names;
  for (std::size_t i = 0; i < array.markers.size(); ++i) {
    const Marker& marker = array.markers[i];
    EXPECT_EQ(marker.header.frame_id, frame);
    const auto& q = marker.pose.orientation;
    EXPECT_NEAR(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w, 1.0, 1e-6) << marker.ns;
    for (const double value : {marker.pose.position.x, marker.pose.position.y, marker.pose.position.z,
                               marker.scale.x, marker.scale.y, marker.scale.z}) {
      EXPECT_TRUE(std::isfinite(value)) << marker.ns;
    }
    for (const auto& point : marker.points) {
      EXPECT_TRUE(std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z)) << marker.ns;
    }
    if (i == 0) continue;
    EXPECT_EQ(marker.action, Marker::ADD);
    EXPECT_GT(marker.color.a, 0.0f);
    EXPECT_TRUE(names.emplace(marker.ns, marker.id).second) << marker.ns << " " << marker.id;
    if (marker.type == Marker::TEXT_VIEW_FACING) {
      EXPECT_FALSE(marker.text.empty());
      EXPECT_GT(marker.scale.z, 0.0);
    }
  }
}

std::size_t countOf(const visualization_msgs::MarkerArray& array, const std::string& ns) {
  std::size_t count = 0;
  for (const Marker& marker : array.markers) count += marker.ns == ns ? 1 : 0;
  return count;
}

BoxArray boxes() {
  BoxArray array;
  array.header.frame_id = "base";
  array.boxes.resize(3);
  for (Box& box : array.boxes) {
    box.pose.pose.orientation.w = 1.0;
    box.size.x = box.size.y = box.size.z = 0.2;
  }
  array.boxes[1].flags = Box::OCCLUDED;
  array.rejected.resize(2);
  array.rejected[0].reason = RejectedCluster::TOO_SMALL;
  array.rejected[1].reason = 200;
  return array;
}

TEST(BoxMarkers, oneOfEachForEveryBox) {
  const auto array = boxMarkers(boxes());
  expectSound(*array, "base");
  for (const char* ns : {"boxes", "outlines", "labels", "uncertainty", "uncertainty_labels"})
    EXPECT_EQ(countOf(*array, ns), 3u) << ns;
  for (const char* ns : {"rejected", "rejected_labels"}) EXPECT_EQ(countOf(*array, ns), 2u) << ns;
}

TEST(BoxMarkers, clearThePictureWhenThereIsNone) {
  BoxArray none;
  none.header.frame_id = "base";
  const auto array = boxMarkers(none);
  expectSound(*array, "base");
  EXPECT_EQ(array->markers.size(), 1u);
}

TEST(BoxMarkers, leaveOutWhatIsNotFinite) {
  BoxArray array = boxes();
  array.boxes[0].pose.pose.position.x = std::nan("");
  array.boxes[1].size.z = std::numeric_limits<double>::infinity();
  array.boxes[1].top_center.z = std::nan("");
  array.boxes[2].pose.pose.orientation.w = 0.0;
  array.rejected[0].centroid.y = std::nan("");
  expectSound(*boxMarkers(array), "base");
}

const Marker& firstOf(const visualization_msgs::MarkerArray& array, const std::string& ns) {
  for (const Marker& marker : array.markers) {
    if (marker.ns == ns) return marker;
  }
  throw std::invalid_argument("no marker in namespace " + ns);
}

TEST(BoxMarkers, colourTellsTheState) {
  BoxArray array = boxes();
  const auto tone = [&](std::uint8_t flags) {
    array.boxes[0].flags = flags;
    const auto color = firstOf(*boxMarkers(array), "boxes").color;
    return std::make_tuple(color.r, color.g, color.b);
  };
  EXPECT_NE(tone(0), tone(Box::TOUCHING));
  EXPECT_EQ(tone(Box::OCCLUDED), tone(Box::TOUCHING));
  EXPECT_NE(tone(Box::TRUNCATED), tone(Box::TOUCHING));
  EXPECT_EQ(tone(Box::TRUNCATED | Box::OCCLUDED), tone(Box::HEIGHT_UNKNOWN));
}

TEST(BoxMarkers, uncertaintyIsAroundTheBoxAlongItsOwnAxes) {
  BoxArray array = boxes();
  Box& box = array.boxes[0];
  box.pose.pose.orientation.w = box.pose.pose.orientation.z = std::sqrt(0.5);  // a quarter turn
  box.pose.covariance[0] = 0.01 * 0.01;  // along the frame's x: the box's y
  box.size_stddev.z = 0.04;
  const auto reach = [](const Marker& edges) {
    Eigen::Vector3d most = Eigen::Vector3d::Zero();
    for (const auto& p : edges.points) most = most.cwiseMax(Eigen::Vector3d(p.x, p.y, p.z));
    return most;
  };
  const auto all = boxMarkers(array);
  const Eigen::Vector3d beyond = reach(firstOf(*all, "uncertainty")) - reach(firstOf(*all, "outlines"));
  EXPECT_LT((beyond - Eigen::Vector3d(0.0, 0.02, 0.04)).norm(), 1e-9) << beyond.transpose();
  EXPECT_EQ(firstOf(*all, "uncertainty_labels").text, " \n \n+-0.0 0.0 80.0");
  array.boxes[0].size_stddev.x = 0.4;
  EXPECT_EQ(firstOf(*boxMarkers(array), "uncertainty_labels").text, " \n \n+-? 0.0 80.0") << "not known";
}

PalletState pallet() {
  PalletState state;
  state.header.frame_id = "pallet";
  state.is_open = 1;
  state.pallet_id = "p";
  state.size.x = 1.2;
  state.size.y = 0.8;
  state.size.z = 0.6;
  state.placements.resize(2);
  for (Placement& placement : state.placements) {
    placement.size.x = placement.size.y = placement.size.z = 0.2;
    placement.pose.orientation.w = 1.0;
  }
  state.spaces.resize(3);
  state.has_pending = 1;
  state.pending = state.placements[0];
  state.pending.approach.z = -1.0;
  return state;
}

TEST(PalletMarkers, showBoxesSpacesAndTheNextPlace) {
  const auto array = palletMarkers(pallet());
  expectSound(*array, "pallet");
  for (const char* ns : {"placed", "placed_outlines", "placed_labels"})
    EXPECT_EQ(countOf(*array, ns), 2u) << ns;
  EXPECT_EQ(countOf(*array, "spaces"), 6u);
  EXPECT_EQ(countOf(*array, "next_approach"), 1u);
  for (const char* ns : {"pallet", "volume", "center_of_gravity", "title"})
    EXPECT_EQ(countOf(*array, ns), 1u) << ns;
}

TEST(PalletMarkers, nothingButDeletionWithoutAPallet) {
  PalletState state;
  state.header.frame_id = "pallet";
  EXPECT_EQ(palletMarkers(state)->markers.size(), 1u);
}

}  // namespace
}  // namespace mixed_palletizing::adapters

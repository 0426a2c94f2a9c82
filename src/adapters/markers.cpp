#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <mixed_palletizing/adapters/markers.hpp>
#include <mixed_palletizing/adapters/message_parts.hpp>
#include <mixed_palletizing/adapters/units.hpp>
#include <mixed_palletizing/detection/detections.hpp>

#include "marker_shapes.hpp"

namespace mixed_palletizing::adapters {
namespace {

constexpr std::uint32_t kWhite = 0xffffff;
constexpr std::uint32_t kGood = 0x2ca02c;
constexpr std::uint32_t kFlagged = 0xe6b800;
constexpr std::uint32_t kPartial = 0xff7f0e;
constexpr std::uint32_t kRefused = 0xd62728;
constexpr std::uint32_t kRefusedWords = 0xffb3a7;  // readable on a grey floor
constexpr std::uint32_t kWood = 0xa07850;
constexpr std::uint32_t kSpace = 0x4aa3df;
constexpr std::uint32_t kNext = 0xff7f0e;
constexpr double kLineM = 0.007;
constexpr double kLetterM = 0.07;
constexpr double kSmallestLetterM = 0.025;
constexpr double kLetterShare = 0.18;       // of the length of a box: its size in one line is about as long
constexpr std::size_t kReasonLetters = 32;  // in a line of the reason of a refusal
constexpr double kInflateM = 0.006;  // drawn around the cloud's points, which would otherwise hide the faces
constexpr double kSigmas = 2.0;      // of the solid drawn around a box: 95 %
constexpr double kUnknownM = 0.1;    // a side that may be off by more is not known
constexpr double kCarrierM = 0.10;   // height of the carrier in the picture

std::string millimeters(const geometry_msgs::Vector3& size) {
  const auto mm = [](double m) {
    return std::isfinite(m) ? std::to_string(std::lround(m * kMillimetersPerMeter)) : "?";
  };
  return mm(size.x) + "x" + mm(size.y) + "x" + mm(size.z);
}

std::string flagWords(std::uint8_t flags) {
  std::string words;
  if ((flags & Box::OCCLUDED) != 0) words += " occluded";
  if ((flags & Box::TRUNCATED) != 0) words += " truncated";
  if ((flags & Box::TOUCHING) != 0) words += " touching";
  if ((flags & Box::UNEVEN_TOP) != 0) words += " uneven";
  if ((flags & Box::INCOMPLETE) != 0) words += " incomplete";
  if ((flags & Box::HEIGHT_UNKNOWN) != 0) words += " height unknown";
  return words;
}

/// The words in lines that end at a comma or after kReasonLetters: rviz draws long lines across everything.
std::string wrapped(const std::string& words) {
  std::string lines;
  std::size_t length = 0;
  for (const char letter : words) {
    const bool breaks =
        letter == ' ' && ((!lines.empty() && lines.back() == ',') || length >= kReasonLetters);
    lines += breaks ? '\n' : letter;
    length = breaks ? 0 : length + 1;
  }
  return lines;
}

/// Green: nothing to remark; yellow: flagged, the size holds; orange: the size is not that of the whole box.
std::uint32_t toneOf(std::uint8_t flags) {
  if ((flags & (Box::TRUNCATED | Box::INCOMPLETE | Box::HEIGHT_UNKNOWN)) != 0) return kPartial;
  return flags == 0 ? kGood : kFlagged;
}

/// Half-width along each axis of the box [m] within which a side lies with one standard deviation.
Eigen::Vector3d sideDeviation(const Box& box, const geometry::Pose& pose) {
  Eigen::Matrix3d position;
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column) {
      position(row, column) = box.pose.covariance[static_cast<std::size_t>(6 * row + column)];
    }
  }
  const Eigen::Matrix3d own = pose.linear().transpose() * position * pose.linear();
  const Eigen::Vector3d half = toEigen(box.size_stddev) / 2.0;
  return (own.diagonal().cwiseMax(0.0) + half.cwiseProduct(half)).cwiseSqrt();
}

std::string deviationWords(const geometry_msgs::Vector3& stddev) {
  const auto mm = [](double m) {
    if (!(kSigmas * m <= kUnknownM)) return std::string("?");
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", kSigmas * m * kMillimetersPerMeter);
    return std::string(text);
  };
  return "+-" + mm(stddev.x) + " " + mm(stddev.y) + " " + mm(stddev.z);
}

geometry::Pose poseOf(const geometry_msgs::Pose& message) {
  geometry::Pose pose = geometry::Pose::Identity();
  const auto& q = message.orientation;
  if (isRotation(q)) pose.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  pose.translation() = toEigen(message.position);
  return pose;
}

geometry::Pose at(const Eigen::Vector3d& center) { return geometry::poseFromYaw(center, 0.0); }

/// Placed boxes are drawn along the pallet's axes, whatever their own axes are.
Eigen::Vector3d centerOf(const Placement& placement) {
  return toEigen(placement.origin) + toEigen(placement.size) / 2.0;
}

void addPlaced(const PalletState& state, MarkerSet& set) {
  for (std::size_t i = 0; i < state.placements.size(); ++i) {
    const Placement& placement = state.placements[i];
    const Eigen::Vector3d size = toEigen(placement.size);
    const Eigen::Vector3d center = centerOf(placement);
    set.cuboid("placed", at(center), size, paletteColor(placement.type_index));
    set.edges("placed_outlines", at(center), size, kLineM, color(0x202020));
    const Eigen::Vector3d top = center + Eigen::Vector3d(0, 0, size.z() / 2 + 0.9 * kLetterM);
    set.text("placed_labels", top, kLetterM, std::to_string(i + 1), color(kWhite));
  }
}

void addNext(const Placement& next, MarkerSet& set) {
  const Eigen::Vector3d size = toEigen(next.size);
  const Eigen::Vector3d center = centerOf(next);
  const Eigen::Vector3d approach = toEigen(next.approach);
  set.cuboid("next", at(center), size, color(kNext, 0.45f));
  set.edges("next", at(center), size, 1.5 * kLineM, color(kNext));
  const Eigen::Vector3d tip = center - approach * (size.z() / 2);
  set.arrow("next_approach", tip - approach * 0.35, tip, 0.03, color(kNext));
}

void addSpaces(const PalletState& state, MarkerSet& set) {
  constexpr double kSheetM = 0.004;
  for (const Space& space : state.spaces) {
    const Eigen::Vector3d low = toEigen(space.min);
    const Eigen::Vector3d high = toEigen(space.max);
    Eigen::Vector3d floor_size = high - low;
    floor_size.z() = kSheetM;
    Eigen::Vector3d center = (low + high) / 2.0;
    set.edges("spaces", at(center), high - low, kLineM / 2, color(kSpace, 0.6f));
    center.z() = low.z() + kSheetM / 2;
    set.cuboid("spaces", at(center), floor_size, color(kSpace, 0.25f));
  }
}

/// Height of the letters of a box's label: labels of small boxes side by side do not cover each other.
double letterOf(const Box& box) {
  return std::isfinite(box.size.x) ? std::clamp(kLetterShare * box.size.x, kSmallestLetterM, kLetterM)
                                   : kLetterM;
}

void addBox(const Box& box, MarkerSet& set) {
  const geometry::Pose pose = poseOf(box.pose.pose);
  const Eigen::Vector3d size = toEigen(box.size).array() + kInflateM;
  const std::uint32_t tone = toneOf(box.flags);
  set.cuboid("boxes", pose, size, color(tone, 0.4f));
  set.edges("outlines", pose, size, 1.5 * kLineM, color(tone));
  set.edges("uncertainty", pose, size + 2.0 * kSigmas * sideDeviation(box, pose), kLineM / 3,
            color(kWhite, 0.7f));
  const double letter = letterOf(box);
  // Blank lines keep the two apart from every side: rviz turns texts to the viewer about their middle.
  const Eigen::Vector3d above = toEigen(box.top_center) + Eigen::Vector3d(0, 0, 2.0 * letter);
  set.text("labels", above, letter,
           "#" + std::to_string(box.id) + flagWords(box.flags) + "\n" + millimeters(box.size) + "\n ",
           color(kWhite));
  set.text("uncertainty_labels", above, letter, " \n \n" + deviationWords(box.size_stddev),
           color(kWhite, 0.8f));
}

}  // namespace

visualization_msgs::MarkerArrayPtr boxMarkers(const BoxArray& boxes) {
  MarkerSet set(boxes.header);
  for (const Box& box : boxes.boxes) addBox(box, set);
  for (const RejectedCluster& cluster : boxes.rejected) {
    const Eigen::Vector3d center = toEigen(cluster.centroid);
    set.edges("rejected", at(center), toEigen(cluster.extent), kLineM, color(kRefused));
    const auto reason = static_cast<detection::RejectReason>(cluster.reason);
    const std::string words = std::string(detection::toString(reason)) + ":\n" + wrapped(cluster.text);
    const auto lines = static_cast<double>(1 + std::count(words.begin(), words.end(), '\n'));
    set.text("rejected_labels",
             center + Eigen::Vector3d(0, 0, cluster.extent.z / 2 + kSmallestLetterM * lines),
             kSmallestLetterM, words, color(kRefusedWords));
  }
  return set.take();
}

visualization_msgs::MarkerArrayPtr palletMarkers(const PalletState& state) {
  MarkerSet set(state.header);
  if (state.is_open == 0) return set.take();
  const Eigen::Vector3d size = toEigen(state.size);
  set.cuboid("pallet", at({size.x() / 2, size.y() / 2, -kCarrierM / 2}), {size.x(), size.y(), kCarrierM},
             color(kWood));
  set.edges("volume", at(size / 2), size, kLineM / 2, color(kWhite, 0.5f));
  addPlaced(state, set);
  addSpaces(state, set);
  if (state.has_pending != 0) addNext(state.pending, set);
  if (!state.placements.empty()) {
    set.sphere("center_of_gravity", toEigen(state.center_of_gravity), 0.05, color(kRefused));
  }
  set.text("title", {size.x() / 2, size.y() / 2, size.z() + 4.0 * kLetterM}, kLetterM,
           state.pallet_id + ":\n" + std::to_string(state.placements.size()) + " boxes, " +
               std::to_string(std::lround(state.utilization * 100.0)) + " %",
           color(kWhite));
  return set.take();
}

}  // namespace mixed_palletizing::adapters

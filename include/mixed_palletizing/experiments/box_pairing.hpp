// Which detection is which box of the scene.
//
// A detection is a box when their tops are within kHighestStep of one height, and
//   - their footprints share at least kLeastOverlap of their union, and their centres lie within a quarter of
//     the box's width; or
//   - a part of the box is out of sight (TrueBox::visible_ratio below kWholeTop) and the detection says
//     itself that it is partial (OCCLUDED, TRUNCATED or INCOMPLETE), or the box need not be found; then at
//     least kLeastInside of the smaller footprint must lie in the other.
// Pairs are taken one to one, those with the larger shared part of the union first. Two boxes reported as one
// share at most two thirds of the union with one of them when they are not very unequal, and the centre is
// off: neither is found.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <mixed_palletizing/detection/detections.hpp>
#include <mixed_palletizing/experiments/scene_truth.hpp>

namespace mixed_palletizing::experiments {

constexpr double kHighestStep = 0.03;  ///< [m]
constexpr double kLeastOverlap = 0.6;
constexpr double kLargestShift = 0.25;  ///< of the width
constexpr double kLeastInside = 0.7;
constexpr double kWholeTop = 0.98;

/// Area [m^2] that two rectangles share.
double sharedArea(const geometry::Rectangle& a, const geometry::Rectangle& b);

/// Index of the detection of every true box; nothing for a box that was not found.
std::vector<std::optional<std::size_t>> pairBoxes(const std::vector<TrueBox>& truth,
                                                  const std::vector<detection::DetectedBox>& detected);

}  // namespace mixed_palletizing::experiments

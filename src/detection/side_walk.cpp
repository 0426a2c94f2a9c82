#include "side_walk.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mixed_palletizing::detection {
namespace {

constexpr double kReachIn_m = 0.032;   // and inside: depth is smeared outwards
constexpr double kLeastEdge = 8.0;     // mean step of brightness along a clear edge
constexpr double kClearShare = 0.45;   // of the clearest edge: others that count
constexpr float kClearStep = 4.0f;     // at one place of an edge
constexpr double kClearLength = 0.6;   // share of an edge's length that shows it
constexpr float kLargestStep = 40.0f;  // print on the top does not count for more
constexpr int kTurns = 4;              // to each side
constexpr double kTurnStep = 0.0125;   // slope of each

double outward(std::size_t side) { return side == 0 || side == 3 ? -1.0 : 1.0; }

}  // namespace

SideWalk::SideWalk(const TopPicture& picture, const TopPart& part, std::size_t side, double begin, double end)
    : picture_(picture),
      line_(part[side]),
      upright_(isUpright(side)),
      out_(outward(side)),
      begin_(begin),
      end_(end) {
  findEdge();
}

std::optional<double> SideWalk::endAt(double along, TopCell& behind) const {
  const std::optional<double> end = line_.seam ? seamAt(along) : surfaceEnd(along);
  if (!end) return std::nullopt;
  behind = kindBehind(along, *end);
  if (!edge_) return end;
  return stepNear(along, edge_->out + edge_->slope * (along - middle()));
}

std::pair<int, int> SideWalk::cellAt(double along, double across) const {
  const int a = static_cast<int>(std::lround(along));
  const int b = static_cast<int>(std::lround(across));
  return upright_ ? std::make_pair(b, a) : std::make_pair(a, b);
}

bool SideWalk::isTop(double along, double across) const {
  const auto [u, v] = cellAt(along, across);
  return picture_.isTop(u, v);
}

TopCell SideWalk::kindAt(double along, double across) const {
  const auto [u, v] = cellAt(along, across);
  return picture_.holds(u, v) ? picture_.kind(u, v) : TopCell::kNoData;
}

/// What a step or more beyond an end shows: the foot of something higher stands at the height of the top.
TopCell SideWalk::kindBehind(double along, double end) const {
  for (double out = 2.0; out * picture_.cell() < kReachOut_m; out += 1.0) {
    if (kindAt(along, end + out * out_) == TopCell::kAbove) return TopCell::kAbove;
  }
  return kindAt(along, end + 2.0 * out_);
}

float SideWalk::grayAt(double along, double across) const {
  const auto [u, v] = cellAt(along, across);
  return picture_.holds(u, v) ? picture_.gray(u, v) : HeightRaster::kNone;
}

/// Change of brightness outwards, `out` cells beyond the line.
float SideWalk::stepAt(double along, double out) const {
  const double across = nominal(along) + out_ * out;
  return grayAt(along, across + out_) - grayAt(along, across - out_);
}

/// The clearest of the slanted lines of brightness that cross the middle of the side at `out`.
SideWalk::Edge SideWalk::clearest(double out) const {
  Edge best;
  for (int turn = -kTurns; turn <= kTurns; ++turn) {
    Edge edge{out, turn * kTurnStep, 0.0};
    int count = 0;
    int brighter = 0;
    int darker = 0;
    for (double along = begin_; along <= end_; along += 1.0) {
      const float step = stepAt(along, edge.out + edge.slope * (along - middle()));
      if (std::isnan(step)) continue;
      edge.rise += static_cast<double>(std::clamp(step, -kLargestStep, kLargestStep));
      brighter += step > kClearStep ? 1 : 0;
      darker += step < -kClearStep ? 1 : 0;
      ++count;
    }
    // Print steps too, but not from end to end.
    if (std::max(brighter, darker) < kClearLength * count) continue;
    if (2 * count < static_cast<int>(end_ - begin_) || count == 0) continue;
    edge.rise /= count;
    if (std::abs(edge.rise) > std::abs(best.rise)) best = edge;
  }
  best.out = out;
  return best;
}

/// The innermost of the clear lines of brightness around the side: the edge of the top, not of what lies below it.
void SideWalk::findEdge() {
  const int in = static_cast<int>(std::lround(kReachIn_m / picture_.cell()));
  const int out = line_.seam ? 0 : static_cast<int>(std::lround(kReachOut_m / picture_.cell()));
  std::vector<Edge> edges;
  double most = kLeastEdge;
  for (int k = -in; k <= out; ++k) {
    edges.push_back(clearest(k));
    most = std::max(most, std::abs(edges.back().rise));
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const double rise = std::abs(edges[i].rise);
    const bool peak = (i == 0 || rise >= std::abs(edges[i - 1].rise)) &&
                      (i + 1 == edges.size() || rise > std::abs(edges[i + 1].rise));
    if (!peak || rise < kClearShare * most) continue;
    edge_ = edges[i];
    return;
  }
}

/// The strongest step of the edge's sense within two cells of it.
std::optional<double> SideWalk::stepNear(double along, double out) const {
  const double sense = edge_->rise > 0.0 ? 1.0 : -1.0;
  double sum = 0.0;
  double moment = 0.0;
  for (int k = -2; k <= 2; ++k) {
    const double step = sense * static_cast<double>(stepAt(along, out + k));
    if (!(step > kLeastEdge)) continue;
    sum += step;
    moment += step * k;
  }
  if (sum <= 0.0) return std::nullopt;
  return nominal(along) + out_ * (out + moment / sum);
}

/// Centre of the evidence for a seam.
std::optional<double> SideWalk::seamAt(double along) const {
  const int reach = std::max(1, static_cast<int>(std::lround(0.5 * kReachOut_m / picture_.cell())));
  double sum = 0.0;
  double moment = 0.0;
  for (int k = -reach; k <= reach; ++k) {
    const double across = nominal(along) + k;
    const double evidence =
        upright_ ? seamEvidence(picture_, across, along, true) : seamEvidence(picture_, along, across, false);
    sum += evidence;
    moment += evidence * across;
  }
  if (sum < 0.5) return std::nullopt;
  return moment / sum;
}

/// From the inside outwards: the last cell of the top before something else.
std::optional<double> SideWalk::surfaceEnd(double along) const {
  const int reach = std::max(2, static_cast<int>(std::lround(kReachOut_m / picture_.cell())));
  std::optional<double> end;
  for (int k = -reach; k <= reach; ++k) {
    const double across = nominal(along) + out_ * k;
    if (isTop(along, across)) {
      end = across + 0.5 * out_;
    } else if (end) {
      break;
    }
  }
  return end;
}

}  // namespace mixed_palletizing::detection

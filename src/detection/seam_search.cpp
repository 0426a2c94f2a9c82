#include "seam_search.hpp"

#include <algorithm>
#include <cmath>

#include "window_sums.hpp"

namespace mixed_palletizing::detection {
namespace {

constexpr int kNear = 2;                 // places next to a seam that may belong to it
constexpr int kWindow = 5;               // places beyond these that show one side
constexpr float kTooFew = 2.0f;          // seen of a window
constexpr double kLeastColorStep = 4.0;  // of 255
constexpr double kColorSigmas = 4.0;
constexpr double kLeastDip = 0.00015;  // [m] mean along the seam
constexpr double kUnevenDip = 0.001;   // [m] the same on an uneven surface
constexpr double kDipSigmas = 7.0;
constexpr double kPartShare = 0.3;      // of the mean dip that every part must show, less its noise
constexpr double kColorShare = 0.8;     // of a seam's lines that must show the step
constexpr double kInsideShare = 0.75;   // of a stretch's lines that have surface on both sides
constexpr double kFar = 0.02;           // [m] to both sides of a seam there must be surface
constexpr double kShortest = 0.015;     // [m]
constexpr double kMargin = 0.004;       // [m] at the ends of a stretch that may be torn
constexpr int kRoom = kNear + kWindow;  // places at both ends that have no window

}  // namespace

void SeamSearch::Sums::clear(std::size_t count) {
  inside.assign(count, 0);
  steps.assign(count, 0);
  dip.assign(count, 0.0);
}

void SeamSearch::Sums::add(const std::vector<float>& inside_of, const std::vector<float>& steps_of,
                           const std::vector<float>& dip_of) {
  for (std::size_t i = 0; i < inside.size(); ++i) {
    inside[i] += static_cast<int>(inside_of[i]);
    steps[i] += static_cast<int>(steps_of[i]);
    dip[i] += static_cast<double>(dip_of[i]);
  }
}

/// Room for one line of the lattice.
void SeamSearch::prepare() {
  color_step_ = static_cast<float>(std::max(kLeastColorStep, kColorSigmas * lattice_.colorNoise()));
  for (std::size_t k = 0; k < kFarSamples; ++k) {
    const double share = 0.5 + 0.5 * static_cast<double>(k + 1) / static_cast<double>(kFarSamples);
    far_[k] = static_cast<std::size_t>(kFar / lattice_.step() * share);
  }
  room_ = std::max<std::size_t>(kRoom + kWindow, far_.back());
  const auto count = static_cast<std::size_t>(lattice_.count());
  for (auto* values : {&top_, &third_, &surface_, &top_sum_, &surface_sum_, &surface_sum_back_, &color_[0],
                       &color_[1], &color_[2], &color_sum_[0], &color_sum_[1], &color_sum_[2]}) {
    values->assign(count + 2 * room_, 0.0f);
  }
  for (auto* values : {&inside_, &step_, &dip_}) values->assign(count, 0.0f);
  wide_.assign(count > 2 * kRoom ? count - 2 * kRoom : 0, 0.0f);
}

void SeamSearch::readLine(int line) {
  const std::uint8_t* __restrict__ tops = lattice_.tops(line);
  const float* __restrict__ heights = lattice_.heights(line);
  float* __restrict__ top = top_.data() + room_;
  float* __restrict__ third = third_.data() + room_;
  float* __restrict__ surface = surface_.data() + room_;
  const auto count = static_cast<std::size_t>(lattice_.count());
  for (std::size_t i = 0; i < count; ++i) {
    top[i] = static_cast<float>(tops[i]);
    third[i] = heights[i] / 3.0f;
    surface[i] = tops[i] != 0 ? heights[i] : 0.0f;
  }
  static_assert(kWindow == 5, "the sums are written out");
  sumForwards(top_, top_sum_);
  sumForwards(surface_, surface_sum_);
  sumBackwards(surface_, surface_sum_back_);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint8_t* __restrict__ color = lattice_.colors(line, k);
    float* __restrict__ to = color_[k].data() + room_;
    for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<float>(color[i]);
    sumForwards(color_[k], color_sum_[k]);
  }
}

/// Whether the surface reaches far enough to both sides of every place to be two tops: beside an edge, a strip of the
/// face below passes for surface.
void SeamSearch::lookFar() {
  const auto on = [&](std::size_t k, std::ptrdiff_t sign) {
    const float* first = top_.data() + room_ + kRoom + sign * static_cast<std::ptrdiff_t>(far_[k]);
    return Eigen::Map<const Eigen::ArrayXf>(first, static_cast<Eigen::Index>(wide_.size()));
  };
  static_assert(kFarSamples == 5, "the sums are written out");
  Eigen::Map<Eigen::ArrayXf> wide(wide_.data(), static_cast<Eigen::Index>(wide_.size()));
  wide = (on(0, -1) + on(1, -1) + on(2, -1) + on(3, -1) + on(4, -1))
             .min(on(0, 1) + on(1, 1) + on(2, 1) + on(3, 1) + on(4, 1));
  wide = (wide - static_cast<float>(kFarSamples / 2)).max(0.0f).min(1.0f);
}

/// Compares the windows on both sides of every place of the line.
void SeamSearch::rateLine() {
  if (wide_.empty()) return;
  lookFar();
  // Sums of the windows before a place, and `high` farther on those of the windows behind it.
  constexpr std::size_t high = kRoom + kNear + 1;
  const auto part = [&](const std::vector<float>& values, std::size_t from) {
    return Eigen::Map<const Eigen::ArrayXf>(values.data() + from, static_cast<Eigen::Index>(wide_.size()));
  };
  const auto rated = [&](std::vector<float>& values) {
    return Eigen::Map<Eigen::ArrayXf>(values.data() + kRoom, static_cast<Eigen::Index>(wide_.size()));
  };
  const auto seen_low = part(top_sum_, room_);
  const auto seen_high = part(top_sum_, room_ + high);
  // Whole numbers: those above 0 become 1.
  auto good = rated(inside_);
  good =
      part(wide_, 0) * (seen_low - kTooFew).max(0.0f).min(1.0f) * (seen_high - kTooFew).max(0.0f).min(1.0f);
  const std::size_t middle = room_ + kRoom;
  rated(dip_) = good * (0.5f * (part(surface_sum_back_, room_) / seen_low.max(1.0f) +
                                part(surface_sum_, room_ + high) / seen_high.max(1.0f)) -
                        (part(third_, middle - 1) + part(third_, middle) + part(third_, middle + 1)));
  // The difference of the mean colours times both counts: whole numbers too, and no divisions.
  auto step = rated(step_);
  step.setZero();
  for (const std::vector<float>& sums : color_sum_) {
    step = step.max((part(sums, room_) * seen_high - part(sums, room_ + high) * seen_low).abs());
  }
  step = good * (step - color_step_ * (seen_low * seen_high)).max(0.0f).min(1.0f);
}

SeamSearch::Peak SeamSearch::rate(int i, int axis, const Stretch& stretch, const TopGroup& group) const {
  const auto at = static_cast<std::size_t>(i);
  const int inside = all_.inside[at];
  Peak peak;
  peak.i = i;
  if (inside < kInsideShare * stretch.count()) return peak;
  const double noise_m = group.scale.noise_m;
  const double dip = all_.dip[at] / inside;
  const double least =
      std::max(group.scale.flat ? kLeastDip : kUnevenDip, kDipSigmas * noise_m / std::sqrt(2.0 * inside));
  bool everywhere = true;
  for (const Sums& part : parts_) {
    const double n = part.inside[at];
    everywhere =
        everywhere && (n == 0 || part.dip[at] / n > kPartShare * dip - 2.0 * noise_m / std::sqrt(2.0 * n));
  }
  peak.by_dip = everywhere ? dip / least : 0.0;
  peak.by_color = static_cast<double>(all_.steps[at]) / (kColorShare * inside);
  const std::array<int, 2> beside{i - kRoom, i + kRoom};
  if (peak.by_color > 1.0 && !(endsAsBoxes(lattice_, seams_, {axis, stretch.from_m, -1}, beside) &&
                               endsAsBoxes(lattice_, seams_, {axis, stretch.to_m, 1}, beside))) {
    peak.by_color = 0.0;
  }
  return peak;
}

void SeamSearch::findIn(int axis, const Stretch& stretch, const TopGroup& group) {
  const auto count = static_cast<std::size_t>(lattice_.count());
  all_.clear(count);
  for (Sums& part : parts_) part.clear(count);
  for (int line = stretch.first; line <= stretch.last; ++line) {
    readLine(line);
    rateLine();
    all_.add(inside_, step_, dip_);
    const int part = static_cast<int>(kParts) * (line - stretch.first) / stretch.count();
    parts_[static_cast<std::size_t>(part)].add(inside_, step_, dip_);
  }
  peaks_.clear();
  for (int i = 0; i < lattice_.count(); ++i) {
    const Peak peak = rate(i, axis, stretch, group);
    if (peak.strength() > 0.0) peaks_.push_back(peak);
  }
  keepPeaks(axis, stretch);
}

/// Whether the change goes on where the surface does so behind a hole, dark print for instance: that of two boxes does,
/// that of a label need not.
bool SeamSearch::goesOnBehind(const SeamEnd& end, SeamWindows windows) {
  const auto [first, last] = linesBehind(lattice_, seams_, end);
  windows.first_line = first;
  windows.last_line = last;
  return colors_.goesOn(lattice_, windows, color_step_);
}

/// Places side by side see one change of colour; only where it is clearest the windows hold one side each.
void SeamSearch::doubtColors(std::size_t begin, std::size_t end, int axis, const Stretch& stretch) {
  const auto windows = [&](int i) { return SeamWindows{i, kNear, kWindow, stretch.first, stretch.last}; };
  double most = 0.0;
  int clearest = -1;
  for (std::size_t k = begin; k < end; ++k) {
    if (peaks_[k].by_color <= 1.0) continue;
    const double change = colors_.changeAt(lattice_, windows(peaks_[k].i));
    if (change <= most) continue;
    most = change;
    clearest = peaks_[k].i;
  }
  if (clearest >= 0 && colors_.differ(lattice_, windows(clearest), color_step_) &&
      goesOnBehind({axis, stretch.from_m, -1}, windows(clearest)) &&
      goesOnBehind({axis, stretch.to_m, 1}, windows(clearest))) {
    return;
  }
  for (std::size_t k = begin; k < end; ++k) peaks_[k].by_color = 0.0;
}

/// A seam is seen by a few places side by side: their middle, by strength.
void SeamSearch::keepPeaks(int axis, const Stretch& stretch) {
  for (std::size_t p = 0; p < peaks_.size();) {
    std::size_t end = p + 1;
    while (end < peaks_.size() && peaks_[end].i - peaks_[end - 1].i <= 2) ++end;
    doubtColors(p, end, axis, stretch);
    double best = 0.0;
    for (std::size_t k = p; k < end; ++k) best = std::max(best, peaks_[k].strength());
    double sum = 0.0;
    double weight = 0.0;
    for (std::size_t k = p; k < end && best > 0.0; ++k) {
      if (peaks_[k].strength() < 0.9 * best) continue;
      sum += peaks_[k].i;
      weight += 1.0;
    }
    if (weight > 0.0) seams_.push_back({axis, lattice_.across(sum / weight), stretch.from_m, stretch.to_m});
    p = end;
  }
}

const std::vector<Seam>& SeamSearch::find(const BaseCloud& cloud, const LevelPieces& pieces,
                                          const TopGroup& group, const TopAxes& axes,
                                          const OutlineLines& lines, const LocalBox& bounds) {
  seams_.clear();
  for (int axis = 0; axis < 2; ++axis) {
    lattice_.look(cloud, pieces, group, axes, bounds, axis);
    prepare();
    breaks_.clear();
    for (const OutlineLine& line : lines[static_cast<std::size_t>(1 - axis)]) breaks_.push_back(line.at_m);
    for (const Seam& seam : seams_) {
      if (seam.axis != axis) breaks_.push_back(seam.at_m);
    }
    std::sort(breaks_.begin(), breaks_.end());
    for (std::size_t b = 0; b + 1 < breaks_.size(); ++b) {
      Stretch stretch{breaks_[b], breaks_[b + 1]};
      if (stretch.to_m - stretch.from_m < kShortest) continue;
      stretch.first = std::max(0, static_cast<int>(std::ceil(lattice_.lineAt(stretch.from_m + kMargin))));
      stretch.last = std::min(lattice_.lines() - 1,
                              static_cast<int>(std::floor(lattice_.lineAt(stretch.to_m - kMargin))));
      if (stretch.count() > 3) findIn(axis, stretch, group);
    }
  }
  return seams_;
}

}  // namespace mixed_palletizing::detection

#include "surface_walk.hpp"

#include <algorithm>
#include <array>

namespace mixed_palletizing::detection {
namespace {

constexpr int kTolerated = 2;        // pixels in a row off the surface that do not end it: drop-outs, strays
constexpr int kMixed = 4;            // pixels of the widest end that counts as drop-outs and mixed pixels
constexpr double kLookShare = 0.20;  // of the image side: how far beyond missing data one looks
constexpr double kBorderShare = 0.03;  // of the image side: an image border this near, behind no data
constexpr std::size_t kFaceKept = 3;   // of the deepest of these give its place
constexpr int kInkFrom = 2;            // pixels beyond an end that are looked at: behind mixed ones ...
constexpr int kInkTo = 4;              // ... and before what comes after
constexpr int kInkLuma = 30;           // of 255
constexpr int kLumaRed = 299;          // of a thousand, ITU-R BT.601
constexpr int kLumaGreen = 587;
constexpr int kLumaBlue = 114;
constexpr double kFaceDepth = 0.04;  // [m] below the top
constexpr double kBandSigmas = 3.5;
constexpr float kBendBands = 3.0f;
constexpr double kWallPixels = 3.0;  // a wall starts within so many pixels of the end

}  // namespace

int SurfaceWalk::go(int most) {
  if (!onSurface(off(0))) return -1;
  int missed = 0;
  for (int i = 1; i < most; ++i) {
    if (!inside(i)) return last_;
    if (onSurface(off(i))) {
      last_ = i;
      missed = 0;
    } else if (++missed > kTolerated) {
      return last_;
    }
  }
  return -1;
}

EdgeSample SurfaceWalk::sample(bool with_face) {
  EdgeSample s;
  s.row = row_ + last_ * down_;
  s.col = col_ + last_ * right_;
  s.along_row = down_ == 0;
  const int beyond = lookBeyond(s.beyond);
  resumes_ = beyond;
  s.soft = beyond == 0 || beyond - last_ > kMixed;
  if (s.soft && (s.beyond == Beyond::kDrop || s.beyond == Beyond::kNoData) && isInkBeyond()) {
    s.beyond = Beyond::kInk;
  }
  double end = last_ + 0.5;
  double level = level_.at(end);
  const int sign = s.beyond == Beyond::kWall ? 1 : -1;
  const bool face_in_gap =
      s.beyond == Beyond::kHole && faceInView() && goesOn(last_ + 1) && off(last_ + 1) < 0.0f;
  if (face_in_gap || (goesOn(beyond) && (s.beyond == Beyond::kDrop || s.beyond == Beyond::kWall))) {
    end = countedEnd(sign);
    level = level_.at(end) + sign * scale_.bend_m;
    s.bent = sign < 0;
    if (with_face && s.beyond == Beyond::kDrop) findFace(beyond, s);
  } else if (s.beyond != Beyond::kHole) {
    end += mixedShare(beyond);
  }
  s.place = at(end, level);
  s.drop_m = s.bent ? static_cast<float>(scale_.bend_m) : -off(last_);
  const Eigen::Vector2d step = at(end + 1.0, level) - s.place;
  const double length = step.norm();
  s.pixel_m = static_cast<float>(length);
  s.outward = step / std::max(length, 1e-9);
  if (s.beyond == Beyond::kHole) s.gap_m = static_cast<float>((beyond - last_ - 1) * length);
  return s;
}

/// Pixels without data tell their colour: those of a shadow are lit by the room, those of ink are black. A driver that
/// has no colour for them leaves it zero.
bool SurfaceWalk::isInkBeyond() const {
  if (!cloud_.view().hasColor()) return false;
  for (int i = last_ + kInkFrom; i <= last_ + kInkTo; ++i) {
    if (!inside(i) || isNumber(off(i))) return false;
    const std::uint8_t* bgr = cloud_.view().bgr(row_ + i * down_, col_ + i * right_);
    const int luma = (kLumaBlue * bgr[0] + kLumaGreen * bgr[1] + kLumaRed * bgr[2]) / 1000;
    if (luma == 0 || luma > kInkLuma) return false;
  }
  return true;
}

bool SurfaceWalk::inside(int i) const {
  const int r = row_ + i * down_;
  const int c = col_ + i * right_;
  return r >= 0 && c >= 0 && r < cloud_.height() && c < cloud_.width();
}

float SurfaceWalk::off(int i) const {
  const Eigen::Vector3f p = point(i);
  return p.z() > 0.0f ? up_.dot(p) + offset_ - level_.at(i) : NAN;
}

Eigen::Vector2d SurfaceWalk::at(double i, double height) const {
  return rays_.placeAt(col_ + i * right_, row_ + i * down_, height);
}

int SurfaceWalk::lookBeyond(Beyond& what) const {
  const int side = down_ != 0 ? cloud_.height() : cloud_.width();
  const int reach = std::max(8, static_cast<int>(kLookShare * side));
  const int border = std::max(2, static_cast<int>(kBorderShare * side));
  bool seen = false;
  what = Beyond::kNoData;
  for (int i = last_ + 1; i <= last_ + reach; ++i) {
    if (!inside(i)) {
      if (!seen && i - last_ <= border) what = Beyond::kBorder;
      return 0;
    }
    const float h = off(i);
    if (!isNumber(h)) continue;
    seen = true;
    if (!inside(i + 1)) {
      what = Beyond::kBorder;
      return 0;
    }
    const Eigen::Vector3f here = point(i);
    const Eigen::Vector3f next = point(i + 1);
    const bool clean = next.z() > 0.0f && std::abs(next.z() - here.z()) < scale_.jump_m;
    if (!clean && i - last_ <= kMixed) continue;
    what = nameOf(h, here, i);
    return i;
  }
  return 0;
}

Beyond SurfaceWalk::nameOf(float h, const Eigen::Vector3f& there, int i) const {
  // Behind a gap an uneven surface may have gone up or down.
  if (std::abs(h) <= static_cast<float>(i - last_ > kMixed ? scale_.band_m : scale_.bend_m))
    return Beyond::kHole;
  if (h < 0.0f) return Beyond::kDrop;
  // A wall is seen by rays that go outwards, and it begins at the end; what hides the rest is seen by the others.
  const double pixel = (at(1.0, level_.begin_m) - at(0.0, level_.begin_m)).norm();
  const bool touches = i - last_ <= kMixed && !faceInView() &&
                       (cloud_.toBase(there) - cloud_.toBase(point(last_))).head<2>().norm() <
                           kWallPixels * pixel * (i - last_) + kBandSigmas * scale_.noise_m;
  return touches ? Beyond::kWall : Beyond::kOccluder;
}

bool SurfaceWalk::goesOn(int beyond) const {
  if (beyond <= 0 || beyond - last_ > kMixed) return false;
  if (std::abs(point(beyond).z() - point(last_).z()) >= scale_.jump_m) return false;
  // Of a face that is not in view only a round edge can be seen, which bends down slowly.
  return faceInView() || std::abs(off(beyond)) < kBendBands * static_cast<float>(scale_.bend_m);
}

double SurfaceWalk::mixedShare(int beyond) const {
  if (beyond > 0 && beyond - last_ <= kMixed) {
    if (faceInView()) return 0.0;
    double share = 0.0;
    for (int i = last_ + 1; i < beyond; ++i) share += isNumber(off(i)) ? 0.5 : scale_.lost_share;
    return share;
  }
  int mixed = 0;
  while (mixed < 2 && inside(last_ + mixed + 1) && isNumber(off(last_ + mixed + 1))) ++mixed;
  const bool shadow = !inside(last_ + mixed + 1) || !isNumber(off(last_ + mixed + 1));
  return shadow ? mixed : 0.0;
}

bool SurfaceWalk::faceInView() const {
  const Eigen::Vector2d outward = at(last_ + 1.0, level_.begin_m) - at(last_, level_.begin_m);
  return rays_.ray(col_ + last_ * right_, row_ + last_ * down_).head<2>().dot(outward) < 0.0;
}

double SurfaceWalk::countedEnd(int sign) const {
  const double pixel = (at(1.0, level_.begin_m) - at(0.0, level_.begin_m)).norm();
  const int half =
      std::clamp(static_cast<int>(std::ceil(3.0 * scale_.noise_m / std::max(pixel, 1e-6))), 3, 10);
  const int first = std::max(0, last_ - half);
  const auto band = static_cast<float>(scale_.bend_m);
  int count = 0;
  for (int i = first; i <= last_ + half; ++i) {
    const float h = inside(i) ? off(i) : NAN;
    const bool within = isNumber(h) ? (sign < 0 ? h > -band : h < band) : i <= last_;
    count += within ? 1 : 0;
  }
  return first - 0.5 + count;
}

std::size_t SurfaceWalk::faceEnd(const FacePlaces& places, std::size_t count) const {
  const Eigen::Vector2d outward = (at(last_ + 1.0, level_.begin_m) - at(last_, level_.begin_m)).normalized();
  std::size_t end = 0;
  for (std::size_t i = kFaceKept; i < count; ++i) {
    const Eigen::Vector3d d = places[i] - places[i - kFaceKept];
    const bool steep = -d.z() > std::abs(d.head<2>().dot(outward));
    if (!steep && end > 0) break;
    if (steep) end = i;
  }
  return end;
}

void SurfaceWalk::findFace(int begin, EdgeSample& s) const {
  FacePlaces places;
  std::size_t count = 0;
  float before = point(begin).z();
  for (int i = begin; i < begin + static_cast<int>(kFacePixels) && inside(i); ++i) {
    const float h = off(i);
    if (!isNumber(h)) continue;
    const Eigen::Vector3f p = point(i);
    if (h < -static_cast<float>(kFaceDepth) || std::abs(p.z() - before) > scale_.jump_m) break;
    before = p.z();
    // Noise lifts the first pixels of a face; later ones belong to the top of something that touches it.
    if (h > -static_cast<float>(scale_.bend_m)) {
      if (count >= kFaceKept) break;
      continue;
    }
    places[count++] = cloud_.toBase(p).cast<double>();
  }
  if (count < 2) return;
  // A face in view is a plane; of a round edge the last pixel counts, and the ray that touches it is half a pixel on.
  const bool in_view = faceInView();
  if (in_view) count = faceEnd(places, count);
  if (count < 2) return;
  const std::size_t kept = in_view ? std::min(count, kFaceKept) : 1;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::size_t i = count - kept; i < count; ++i) mean += places[i] / static_cast<double>(kept);
  s.face = mean.head<2>();
  if (!in_view) s.face += 0.5 * (at(last_ + 1.0, level_.begin_m) - at(last_, level_.begin_m));
  s.face_drop_m = level_.at(last_) - static_cast<float>(mean.z());
  s.has_face = true;
}

}  // namespace mixed_palletizing::detection

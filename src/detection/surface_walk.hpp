// One walk over a surface along a row or a column, outwards until the surface ends.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "edge_walks.hpp"

namespace mixed_palletizing::detection {

/// Height of the surface along a walk: an uneven one is followed for a few cells only.
struct WalkLevel {
  float begin_m = 0.0f;
  float rise_m = 0.0f;  ///< per pixel
  int reach = 0;        ///< pixels that it rises for
  float at(double i) const { return begin_m + rise_m * static_cast<float>(std::min<double>(i, reach)); }
};

class SurfaceWalk {
 public:
  SurfaceWalk(const BaseCloud& cloud, const RayModel& rays, const WalkScale& scale, int row, int col,
              int down, int right, const WalkLevel& level)
      : cloud_(cloud),
        rays_(rays),
        scale_(scale),
        up_(cloud.upInCamera()),
        offset_(static_cast<float>(cloud.camera().z())),
        row_(row),
        col_(col),
        down_(down),
        right_(right),
        level_(level) {}

  /// Pixels from the start to the last one on the surface; -1 when the start is not on it, or no end comes within
  /// `most` pixels.
  int go(int most);

  /// What ends the surface where go() came to. `with_face`: look for the face below, too.
  EdgeSample sample(bool with_face);

  /// Pixels from the start to where the level goes on behind the gap that sample() found.
  int resumesAt() const { return resumes_; }

 private:
  static bool isNumber(float x) { return x - x == 0.0f; }

  bool isInkBeyond() const;

  bool inside(int i) const;

  Eigen::Vector3f point(int i) const { return cloud_.view().point(row_ + i * down_, col_ + i * right_); }

  /// Height of a pixel above the surface; not a number without data.
  float off(int i) const;

  bool onSurface(float off) const { return std::abs(off) <= static_cast<float>(scale_.bend_m); }

  Eigen::Vector2d at(double i, double height) const;

  /// First pixel beyond the end that surely lies on another surface: a neighbour has about its depth. 0 when there
  /// is none.
  int lookBeyond(Beyond& what) const;

  Beyond nameOf(float h, const Eigen::Vector3f& there, int i) const;

  bool goesOn(int beyond) const;

  /// Pixels beyond the last one on the surface that count as the surface's: mixed pixels belong to either side with
  /// equal right, those before a shadow are the surface's own, those of a steep face are not; what has no data is a
  /// shadow, narrow as it may be, but for the share of the scale.
  double mixedShare(int beyond) const;

  /// Whether the camera stands on the outer side of what ends here.
  bool faceInView() const;

  /// Where the surface leaves the band, by the count of pixels within it: each misjudged pixel before the end is
  /// made up for by one behind it.
  double countedEnd(int sign) const;

  /// Mean place of the deepest pixels of the face that begins at `begin`.
  void findFace(int begin, EdgeSample& s) const;

  static constexpr std::size_t kFacePixels = 24;  // down a face
  using FacePlaces = std::array<Eigen::Vector3d, kFacePixels>;

  /// How many of the first places lie on a steep face: behind it the top of something lower may go on.
  std::size_t faceEnd(const FacePlaces& places, std::size_t count) const;

  const BaseCloud& cloud_;

  const RayModel& rays_;

  const WalkScale& scale_;

  const Eigen::Vector3f up_;

  const float offset_;

  const int row_, col_, down_, right_;

  const WalkLevel level_;

  int last_ = 0;
  int resumes_ = 0;
};

}  // namespace mixed_palletizing::detection

// Outline of a level piece: walks along rows and columns outwards until the surface ends, and what ends it.
//
// A side lies between the last pixel on the surface and the first one beyond. Mixed pixels between the two belong to
// either side with equal right, so their middle is taken; pixels without data are the shadow of the side, but for
// a sensor that measures by windows of pixels, which loses both sides of an edge alike. On a face
// that goes on without a jump the pixels above a threshold are counted, which is free of bias whatever the noise.
// Places are where the border's ray reaches the height of the surface (or of the threshold): noise along the ray does
// not move them.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "level_pieces.hpp"
#include "ray_model.hpp"

namespace mixed_palletizing::detection {

/// A gap of the same level that is wider is no seam between boxes that touch [m].
constexpr double kWideSeam = 0.005;

/// What lies beyond an end of the surface.
enum class Beyond : std::uint8_t {
  kDrop,      ///< something lower: a side of the top
  kWall,      ///< a face that rises from the very end: a higher box stands against this one
  kOccluder,  ///< something nearer to the camera: the top goes on behind it
  kHole,      ///< the same level again after a gap
  kBorder,    ///< the border of the image, which is near
  kInk,       ///< print that is too dark to be measured: the top may go on, or its side may be near
  kNoData,    ///< nothing for a long way
};

struct EdgeSample {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();    ///< of the end, base frame [m]
  Eigen::Vector2d outward = Eigen::Vector2d::Zero();  ///< direction of the walk seen from above, length 1
  Eigen::Vector2d face = Eigen::Vector2d::Zero();     ///< of the face below, when has_face [m]
  float face_drop_m = 0.0f;                           ///< of that place below the surface
  float pixel_m = 0.0f;                               ///< length of a pixel along the walk, on the surface
  float gap_m = 0.0f;                                 ///< kHole: from the end to where the level goes on
  int row = 0;
  int col = 0;          ///< the last pixel on the surface
  float drop_m = 0.0f;  ///< of the place (bent) or of the last pixel (else) below the surface
  bool bent =
      false;  ///< the surface bends down there; else it ends at a jump, and the place lies on its level
  bool along_row = true;
  bool has_face = false;
  bool soft =
      false;  ///< a long way without data lies beyond: an edge before a shadow, or the rim of dark print
  Beyond beyond = Beyond::kDrop;

  /// True when the end is one of the solid itself.
  bool isEdge() const {
    return beyond == Beyond::kDrop || beyond == Beyond::kWall || beyond == Beyond::kNoData;
  }
};

/// Heights that a piece is walked by.
struct WalkScale {
  double noise_m = 0.0;  ///< standard deviation of a pixel's height
  double band_m = 0.0;   ///< pixels this near to the surface are on it
  double bend_m = 0.0;   ///< the same where the surface is followed from cell to cell; band_m of a flat one
  double jump_m = 0.0;   ///< depths of neighbours that differ by more are two surfaces
  double lost_share = 0.0;  ///< of the pixels without data before a jump, that belong to the surface
  bool flat = true;         ///< the piece is its plane; else every cell its own level
};

WalkScale walkScale(const LevelPiece& piece, const SensorNoise& noise, const RayModel& rays);

/// Adds the samples of one piece.
void walkEdges(const BaseCloud& cloud, const CellGrid& cells, const LevelPieces& pieces, int piece,
               const RayModel& rays, const WalkScale& scale, std::vector<EdgeSample>& samples);

}  // namespace mixed_palletizing::detection

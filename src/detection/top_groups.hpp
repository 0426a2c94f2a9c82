// Level pieces that may belong to the same tops: alone, or torn apart by a band without data or by something that
// hides the middle.
#pragma once

#include <optional>
#include <vector>

#include "top_raster.hpp"

namespace mixed_palletizing::detection {

/// Keeps its memory between calls.
class TopGroups {
 public:
  /// Walks the outlines of all pieces and groups those that are one level, near, and look across to each other.
  const std::vector<TopGroup>& find(const BaseCloud& cloud, const CellGrid& cells, const SensorNoise& noise,
                                    const LevelPieces& pieces);

 private:
  struct Outline {
    RayModel rays;
    WalkScale scale;
    PixelBox box;
    std::vector<EdgeSample> samples;
    double yaw_rad = 0.0;
    double pixel_m = 0.0;
    bool open = false;                   ///< the surface may go on beyond something
    LocalBox bounds;                     ///< of the samples, along the yaw
    std::optional<std::size_t> dent_of;  ///< larger piece that it lies in
    bool usable = false;
  };
  void trace(const BaseCloud& cloud, const CellGrid& cells, const SensorNoise& noise,
             const LevelPieces& pieces, std::size_t piece);
  bool isDent(const CellGrid& cells, const LevelPieces& pieces, std::size_t small, std::size_t large) const;
  void findDents(const CellGrid& cells, const LevelPieces& pieces);
  TopGroup& addGroup();
  bool together(const LevelPieces& pieces, std::size_t a, std::size_t b) const;

  std::vector<Outline> outlines_;
  std::vector<TopGroup> groups_;
  std::vector<TopGroup> spare_;     // memory of groups before
  std::vector<std::size_t> first_;  // by piece: the first piece of its group
  LineBuffers lines_;
  std::vector<float> pixels_;
};

}  // namespace mixed_palletizing::detection

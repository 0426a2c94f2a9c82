// Seams across a level surface: where two boxes of one height touch.
//
// Along a seam the surface dips or has no data, or the colour changes. A seam is straight, parallel to the axes of
// the outline, and runs all the way from one line of the outline to another; prints and labels seldom do.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "seam_colors.hpp"
#include "seam_ends.hpp"
#include "seam_lattice.hpp"

namespace mixed_palletizing::detection {

/// Keeps its memory between calls.
class SeamSearch {
 public:
  /// Seams of a group's surface, in its axes.
  const std::vector<Seam>& find(const BaseCloud& cloud, const LevelPieces& pieces, const TopGroup& group,
                                const TopAxes& axes, const OutlineLines& lines, const LocalBox& bounds);

 private:
  static constexpr std::size_t kParts = 4;       // of a seam: a dent dips in one of them only
  static constexpr std::size_t kFarSamples = 5;  // on each side of a seam

  /// Sums over lines, one for each place across.
  struct Sums {
    std::vector<int> inside;  // lines with surface on both sides of the place
    std::vector<int> steps;   // and with a change of colour there
    std::vector<double> dip;  // depth below both sides [m]
    void clear(std::size_t count);
    void add(const std::vector<float>& inside_of, const std::vector<float>& steps_of,
             const std::vector<float>& dip_of);
  };
  /// Lines between two lines of the outline, that a seam may run through.
  struct Stretch {
    double from_m = 0.0, to_m = 0.0;
    int first = 0, last = -1;
    int count() const { return last - first + 1; }
  };
  /// A place across, and how much it looks like a seam, by what: above 1 it does.
  struct Peak {
    double by_dip = 0.0;
    double by_color = 0.0;
    int i = 0;
    /// 0 for no seam.
    double strength() const {
      const double most = std::max(by_dip, by_color);
      return most > 1.0 ? most + 0.01 * by_dip : 0.0;
    }
  };

  void prepare();
  void readLine(int line);
  void lookFar();
  void rateLine();
  Peak rate(int i, int axis, const Stretch& stretch, const TopGroup& group) const;
  void findIn(int axis, const Stretch& stretch, const TopGroup& group);
  void keepPeaks(int axis, const Stretch& stretch);
  void doubtColors(std::size_t begin, std::size_t end, int axis, const Stretch& stretch);
  bool goesOnBehind(const SeamEnd& end, SeamWindows windows);

  SeamLattice lattice_;
  SeamColors colors_;
  float color_step_ = 0.0f;  // more is a change of colour; a whole number
  std::size_t room_ = 0;     // at both ends of the line below
  std::array<std::size_t, kFarSamples> far_{};
  // Of one line: the surface (1 or 0), a third of the heights, those of the surface alone, colours; and sums of
  // neighbours.
  std::vector<float> top_, third_, surface_, top_sum_, surface_sum_, surface_sum_back_;
  std::array<std::vector<float>, 3> color_, color_sum_;
  std::vector<float> wide_;                 // 1 where the surface reaches far, from the first place rated on
  std::vector<float> inside_, step_, dip_;  // its places rated
  Sums all_;
  std::array<Sums, kParts> parts_;
  std::vector<double> breaks_;  // along, where lines of the outline or seams cross
  std::vector<Peak> peaks_;
  std::vector<Seam> seams_;
};

}  // namespace mixed_palletizing::detection

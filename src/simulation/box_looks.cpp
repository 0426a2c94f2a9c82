#include "box_looks.hpp"

#include <algorithm>

namespace mixed_palletizing::simulation {
namespace {

constexpr double kBandOffsetRatio = 0.3;  // of the band's middle from the top's, of the side it crosses
constexpr double kMaxDentRatio = 0.25;    // of the height, as a scene allows

/// A rectangle that lies within the top.
BoxLabel drawLabel(const RecipePaint& paint, const SceneBox& box, Draws& draws) {
  BoxLabel label;
  for (int axis = 0; axis < 2; ++axis) {
    label.size_m[axis] = std::min(draws.in(paint.label_size_m), box.size_m[axis]);
    const double room = 0.5 * (box.size_m[axis] - label.size_m[axis]);
    label.center_m[axis] = draws.between(-room, room);
  }
  label.rgb = draws.one(paint.label_rgb);
  return label;
}

/// A band across the top and down the two sides it reaches.
BoxLabel drawBand(const RecipePaint& paint, const SceneBox& box, Draws& draws) {
  const int across = draws.in(CountRange{0, 1});  // the axis along which the band is narrow
  BoxLabel band;
  band.size_m[across] = draws.in(paint.band_width_m);
  band.size_m[1 - across] = box.size_m[1 - across];
  band.center_m[across] = draws.between(-kBandOffsetRatio, kBandOffsetRatio) * box.size_m[across];
  band.rgb = draws.one(paint.band_rgb);
  band.down_sides = true;
  return band;
}

BoxDent drawDent(const RecipeShape& shape, const SceneBox& box, Draws& draws) {
  BoxDent dent;
  for (int axis = 0; axis < 2; ++axis) {
    dent.center_m[axis] = draws.between(-0.5, 0.5) * box.size_m[axis];
  }
  dent.radius_m = draws.in(shape.dent_radius_m);
  dent.depth_m = std::min(draws.in(shape.dent_depth_m), kMaxDentRatio * box.size_m.z());
  return dent;
}

}  // namespace

void paintBox(const RecipePaint& paint, Draws& draws, SceneBox& box) {
  box.rgb = draws.one(paint.carton_rgb);
  const int labels = draws.in(paint.labels);
  for (int i = 0; i < labels; ++i) box.labels.push_back(drawLabel(paint, box, draws));
  if (draws.chance(paint.band_ratio)) box.labels.push_back(drawBand(paint, box, draws));
}
void shapeBox(const RecipeShape& shape, Draws& draws, SceneBox& box) {
  if (draws.chance(shape.bulge_ratio)) box.shape.bulge_m = draws.in(shape.bulge_m);
  if (draws.chance(shape.rounding_ratio)) box.shape.rounding_m = draws.in(shape.rounding_m);
  const int dents = draws.in(shape.dents);
  for (int i = 0; i < dents; ++i) box.shape.dents.push_back(drawDent(shape, box, draws));
  if (!draws.chance(shape.flap_ratio)) return;
  BoxFlap flap;
  flap.side = static_cast<BoxFace>(draws.in(CountRange{0, 3}));
  flap.length_m = draws.in(shape.flap_length_m);
  flap.angle_rad = draws.in(shape.flap_angle_rad);
  box.shape.flaps.push_back(flap);
}

}  // namespace mixed_palletizing::simulation

#include <cmath>

#include <mixed_palletizing/simulation/pinhole.hpp>

namespace mixed_palletizing::simulation {

Pinhole::Pinhole(const Camera& camera)
    : fx_px(0.5 * camera.width_px / std::tan(0.5 * camera.horizontal_fov_rad)),
      fy_px(fx_px),
      cx_px(0.5 * (camera.width_px - 1)),
      cy_px(0.5 * (camera.height_px - 1)) {
  if (!camera.intrinsics) return;
  fx_px = camera.intrinsics->fx_px;
  fy_px = camera.intrinsics->fy_px;
  cx_px = camera.intrinsics->cx_px;
  cy_px = camera.intrinsics->cy_px;
}

}  // namespace mixed_palletizing::simulation

#include <cmath>

#include <mixed_palletizing/simulation/pinhole.hpp>

namespace mixed_palletizing::simulation {

Pinhole::Pinhole(const Camera& camera)
    : focal_px(0.5 * camera.width_px / std::tan(0.5 * camera.horizontal_fov_rad)),
      cx_px(0.5 * (camera.width_px - 1)),
      cy_px(0.5 * (camera.height_px - 1)) {}

}  // namespace mixed_palletizing::simulation

#include <cmath>
#include <stdexcept>

#include <mixed_palletizing/simulation/camera.hpp>
#include <mixed_palletizing/simulation/pinhole.hpp>

namespace mixed_palletizing::simulation {

const std::vector<CameraModel>& cameraModels() {
  // One: thesis 2.1. Two (M70): the maker's data sheet. Two+ (M130): the maker's page on sampling, 0.32 mm between
  // pixels at 1300 mm, and its data sheet. The projector stands to the right (the maker's page on the camera's
  // coordinate system); the distance to it is not published and is estimated from the housing.
  static const std::vector<CameraModel> models = {
      {"zivid_one", 1920, 1200, 0.780, 1.100, 0.600, 1.100, {0.15, 0.0, 0.0}},
      {"zivid_two", 1944, 1200, 0.754, 0.700, 0.500, 0.900, {0.11, 0.0, 0.0}},
      {"zivid_two_plus", 2448, 2048, 0.783, 1.300, 1.000, 1.600, {0.11, 0.0, 0.0}},
  };
  return models;
}

Camera cameraOfModel(const std::string& name) {
  for (const CameraModel& model : cameraModels()) {
    if (model.name != name) continue;
    Camera camera;
    camera.width_px = model.width_px;
    camera.height_px = model.height_px;
    camera.horizontal_fov_rad = 2.0 * std::atan(0.5 * model.field_width_m / model.field_at_m);
    camera.projector_m = model.projector_m;
    return camera;
  }
  throw std::invalid_argument("cameraOfModel: name = '" + name + "' is no model");
}

Camera subsampled(const Camera& camera, int step) {
  if (step != 1 && step != 2 && step != 4) {
    throw std::invalid_argument("subsampled: step = " + std::to_string(step) + " is none of 1, 2, 4");
  }
  const Pinhole full(camera);
  Camera coarse = camera;
  coarse.width_px /= step;
  coarse.height_px /= step;
  // The middle of block i lies at image coordinate step * i + (step - 1) / 2.
  const double middle = 0.5 * (step - 1);
  coarse.intrinsics = Intrinsics{full.fx_px / step, full.fy_px / step, (full.cx_px - middle) / step,
                                 (full.cy_px - middle) / step};
  return coarse;
}

geometry::Pose lookAt(const Eigen::Vector3d& eye, const Eigen::Vector3d& target) {
  const Eigen::Vector3d path = target - eye;
  if (!(path.norm() > 1e-9)) {
    throw std::invalid_argument("lookAt: eye and target are the same point or not finite");
  }
  const Eigen::Vector3d forward = path.normalized();
  const bool vertical = forward.head<2>().norm() < 1e-6;
  const Eigen::Vector3d up = vertical ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d right = forward.cross(up).normalized();
  geometry::Pose world_from_camera = geometry::Pose::Identity();
  world_from_camera.linear().col(0) = right;
  world_from_camera.linear().col(1) = forward.cross(right);
  world_from_camera.linear().col(2) = forward;
  world_from_camera.translation() = eye;
  return world_from_camera;
}

}  // namespace mixed_palletizing::simulation

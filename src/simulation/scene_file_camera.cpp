#include <mixed_palletizing/simulation/pinhole.hpp>

#include "scene_sections.hpp"

namespace mixed_palletizing::simulation {
namespace {

void readCameraPose(YamlSection& section, geometry::Pose& world_from_camera) {
  const bool by_points = section.has("eye_m") && section.has("target_m");
  const bool by_matrix = section.has("world_from_camera");
  Eigen::Vector3d eye = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d target = Eigen::Vector3d::Zero();
  section.read("eye_m", eye);
  section.read("target_m", target);
  section.read("world_from_camera", world_from_camera.matrix());
  const bool any_point = section.has("eye_m") || section.has("target_m");
  if (by_matrix ? any_point : !by_points) {
    section.add("pose", "give either eye_m and target_m or world_from_camera");
  } else if (by_points && (target - eye).norm() < 1e-9) {
    section.add("eye_m", "is the same point as target_m");
  } else if (by_points) {
    world_from_camera = lookAt(eye, target);
  }
  if (world_from_camera.matrix().row(3) != Eigen::RowVector4d(0, 0, 0, 1)) {
    section.add("world_from_camera", "its last row is not 0 0 0 1");
  }
}

/// The image: a model's or the scene's own.
void readImage(YamlSection& section, Camera& camera) {
  const bool of_model = section.has("model");
  std::string model;
  section.read("model", model);
  bool is_known = false;
  for (const CameraModel& known : cameraModels()) is_known = is_known || known.name == model;
  if (is_known) camera = cameraOfModel(model);
  if (of_model && !is_known) section.add("model", "'" + model + "' is no model of a camera");
  for (const char* key : {"width_px", "height_px", "horizontal_fov_deg"}) {
    if (of_model && section.has(key)) section.add(key, "is the model's");
  }
  section.read("width_px", camera.width_px);
  section.read("height_px", camera.height_px);
  section.readAngle("horizontal_fov", camera.horizontal_fov_rad);
}

void readIntrinsics(YamlSection& section, Camera& camera) {
  const Pinhole pinhole(camera);
  Intrinsics own{pinhole.fx_px, pinhole.fy_px, pinhole.cx_px, pinhole.cy_px};
  section.read("fx_px", own.fx_px);
  if (section.has("fx_px")) own.fy_px = own.fx_px;
  section.read("fy_px", own.fy_px);
  section.read("cx_px", own.cx_px);
  section.read("cy_px", own.cy_px);
  for (const char* key : {"fx_px", "fy_px", "cx_px", "cy_px"}) {
    if (section.has(key)) camera.intrinsics = own;
  }
  if (section.has("fx_px") && section.has("horizontal_fov_deg")) {
    section.add("fx_px", "says the same as horizontal_fov_deg: give one of them");
  }
  if (section.has("fy_px") && !section.has("fx_px")) section.add("fy_px", "needs fx_px");
}

void readSubsampling(YamlSection& section, Camera& camera) {
  int step = 1;
  section.read("subsample", step);
  if (step != 1 && step != 2 && step != 4) {
    section.add("subsample", std::to_string(step) + " is none of 1, 2, 4");
  } else if (step > 1) {
    camera = subsampled(camera, step);
  }
}

void readProjector(YamlSection& section, Camera& camera) {
  if (!section.has("projector_m")) return;
  const YAML::Node node = section.take("projector_m");
  camera.projector_m.reset();
  if (node.IsScalar() && node.Scalar() == "none") return;
  camera.projector_m = Eigen::Vector3d::Zero();
  section.read("projector_m", *camera.projector_m);
}

}  // namespace

bool readCamera(YamlSection section, bool with_pose, Camera& camera) {
  readImage(section, camera);
  readIntrinsics(section, camera);
  readSubsampling(section, camera);
  if (with_pose) readCameraPose(section, camera.world_from_camera);
  readProjector(section, camera);
  bool is_ideal = false;
  section.read("ideal", is_ideal);
  if (is_ideal) camera.projector_m.reset();
  section.finish();
  return is_ideal;
}

}  // namespace mixed_palletizing::simulation

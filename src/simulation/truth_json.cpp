#include <algorithm>

#include <nlohmann/json.hpp>

#include <mixed_palletizing/simulation/pinhole.hpp>
#include <mixed_palletizing/simulation/truth_json.hpp>

#include "visibility.hpp"

namespace mixed_palletizing::simulation {
namespace {

using nlohmann::json;

constexpr double kPi = 3.14159265358979323846;

json toJson(const Eigen::Vector3d& v) { return json::array({v.x(), v.y(), v.z()}); }

json toJson(const geometry::Pose& pose) {
  json rows = json::array();
  for (int row = 0; row < 4; ++row) {
    json numbers = json::array();
    for (int col = 0; col < 4; ++col) numbers.push_back(pose.matrix()(row, col));
    rows.push_back(numbers);
  }
  return rows;
}

/// Place, and rotation as quaternion x, y, z, w with w >= 0.
json poseJson(const geometry::Pose& pose) {
  Eigen::Quaterniond q(pose.linear());
  q.normalize();
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  json out;
  out["position"] = toJson(Eigen::Vector3d(pose.translation()));
  out["orientation"] = json::array({q.x(), q.y(), q.z(), q.w()});
  return out;
}

/// Pixels that the nominal cuboid would have alone before an unlimited image: those of the faces that look at the
/// camera.
std::uint64_t pixelsAlone(const SceneBox& box, const Camera& camera) {
  const geometry::Pose camera_from_box = camera.world_from_camera.inverse() * worldFromBox(box);
  const Eigen::Vector3d half = 0.5 * box.size_m;
  std::uint64_t pixels = 0;
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2;
    const Eigen::Vector3d normal = (face % 2 == 0 ? -1.0 : 1.0) * Eigen::Vector3d::Unit(axis);
    const Eigen::Vector3d middle = normal * half[axis];
    if ((camera_from_box.linear() * normal).dot(camera_from_box * middle) >= 0.0) continue;
    const Eigen::Vector3d u = half[(axis + 1) % 3] * Eigen::Vector3d::Unit((axis + 1) % 3);
    const Eigen::Vector3d v = half[(axis + 2) % 3] * Eigen::Vector3d::Unit((axis + 2) % 3);
    pixels += projectedPixels({camera_from_box * (middle - u - v), camera_from_box * (middle + u - v),
                               camera_from_box * (middle + u + v), camera_from_box * (middle - u + v)},
                              Pinhole(camera));
  }
  return pixels;
}

json toJson(const geometry::Pose& world_from_surface, const Marker& marker) {
  json out;
  out["dictionary"] = marker.dictionary;
  out["id"] = marker.id;
  out["corners"] = json::array();
  for (const Eigen::Vector3d& corner : markerCorners(marker)) {
    out["corners"].push_back(toJson(Eigen::Vector3d(world_from_surface * corner)));
  }
  return out;
}

json allMarkers(const Scene& scene) {
  json out = json::array();
  const auto add = [&](const Marker& marker) {
    out.push_back(toJson(worldFromSurface(scene, marker.surface), marker));
  };
  if (scene.has_marker) add(scene.marker);
  for (const Marker& marker : scene.markers) add(marker);
  for (const MarkerBoard& board : scene.boards) {
    for (const Marker& marker : markersOf(board)) add(marker);
  }
  return out;
}

json objectJson(const Scene& scene, std::size_t index, const Capture& capture) {
  const SceneObject& object = scene.objects[index];
  const Extent extent = extentOf(*object.mesh);
  json out;
  out["name"] = object.name.empty() ? "object_" + std::to_string(index + 1) : object.name;
  out["kind"] = object.kind;
  out["mask_value"] = scene.boxes.size() + index + 1;
  out["pose"] = poseJson(object.world_from_object);
  out["pose_in_camera"] =
      poseJson(geometry::Pose(scene.camera.world_from_camera.inverse() * object.world_from_object));
  out["world_from_object"] = toJson(object.world_from_object);
  out["extent"] = json::array({toJson(extent.low), toJson(extent.high)});
  out["visible_pixels"] = capture.object_visible_pixels.at(index);
  return out;
}

json boxJson(const Scene& scene, std::size_t index, const Capture& capture) {
  const SceneBox& box = scene.boxes[index];
  const bool length_first = box.size_m.x() >= box.size_m.y();
  const Eigen::Vector3d size =
      length_first ? box.size_m : Eigen::Vector3d(box.size_m.y(), box.size_m.x(), box.size_m.z());
  const geometry::Pose world_from_box = worldFromBox(box);
  json out;
  out["mask_value"] = index + 1;
  out["name"] = box.name.empty() ? "box_" + std::to_string(index + 1) : box.name;
  out["center"] = toJson(Eigen::Vector3d(world_from_box.translation()));
  out["top_center"] = toJson(Eigen::Vector3d(world_from_box * Eigen::Vector3d(0, 0, 0.5 * size.z())));
  const double yaw = geometry::foldHalfTurn(length_first ? box.yaw_rad : box.yaw_rad + 0.5 * kPi);
  const geometry::Pose world_from_length = geometry::poseFromYaw(world_from_box.translation(), yaw);
  out["yaw"] = yaw;
  out["pose"] = poseJson(world_from_length);
  out["pose_in_camera"] =
      poseJson(geometry::Pose(scene.camera.world_from_camera.inverse() * world_from_length));
  out["size"] = toJson(size);
  const TopOffsets offsets = topOffsets(box);
  out["top_mean_height"] = box.base_z_m + box.size_m.z() + offsets.mean_m;
  out["top_max_deviation"] = std::max(offsets.highest_m, -offsets.lowest_m);
  out["shape_flags"] = shapeFlags(box.shape);
  out["visible_pixels"] = capture.visible_pixels.at(index);
  const double alone = static_cast<double>(std::max<std::uint64_t>(1, pixelsAlone(box, scene.camera)));
  out["visibility"] = std::min(1.0, static_cast<double>(capture.visible_pixels.at(index)) / alone);
  out["top_visibility"] = capture.top_visibility.at(index);
  return out;
}

}  // namespace

std::string truthJson(const Scene& scene, const Capture& capture, std::uint64_t seed) {
  json truth;
  truth["seed"] = seed;
  truth["world_from_camera"] = toJson(scene.camera.world_from_camera);
  truth["base_from_camera"] = nullptr;
  if (scene.has_marker) {
    truth["base_from_camera"] =
        toJson(geometry::Pose(worldFromMarker(scene.marker).inverse() * scene.camera.world_from_camera));
  }
  truth["boxes"] = json::array();
  for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
    truth["boxes"].push_back(boxJson(scene, i, capture));
  }
  truth["objects"] = json::array();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    truth["objects"].push_back(objectJson(scene, i, capture));
  }
  truth["markers"] = allMarkers(scene);
  return truth.dump(2, ' ', true, json::error_handler_t::replace) + "\n";
}

}  // namespace mixed_palletizing::simulation

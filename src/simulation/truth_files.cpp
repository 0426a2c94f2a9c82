#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include <mixed_palletizing/simulation/truth_files.hpp>

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

json toJson(const SceneObject& object, std::size_t index, const Capture& capture) {
  const Extent extent = extentOf(*object.mesh);
  json out;
  out["name"] = object.name.empty() ? "object_" + std::to_string(index + 1) : object.name;
  out["kind"] = object.kind;
  out["world_from_object"] = toJson(object.world_from_object);
  out["extent"] = json::array({toJson(extent.low), toJson(extent.high)});
  out["visible_pixels"] = capture.object_visible_pixels.at(index);
  return out;
}

json toJson(const SceneBox& box, std::size_t index, const Capture& capture) {
  const bool length_first = box.size_m.x() >= box.size_m.y();
  const Eigen::Vector3d size =
      length_first ? box.size_m : Eigen::Vector3d(box.size_m.y(), box.size_m.x(), box.size_m.z());
  const geometry::Pose world_from_box = worldFromBox(box);
  json out;
  out["name"] = box.name.empty() ? "box_" + std::to_string(index + 1) : box.name;
  out["center"] = toJson(Eigen::Vector3d(world_from_box.translation()));
  out["top_center"] = toJson(Eigen::Vector3d(world_from_box * Eigen::Vector3d(0, 0, 0.5 * size.z())));
  out["yaw"] = geometry::foldHalfTurn(length_first ? box.yaw_rad : box.yaw_rad + 0.5 * kPi);
  out["size"] = toJson(size);
  const TopOffsets offsets = topOffsets(box);
  out["top_mean_height"] = box.base_z_m + box.size_m.z() + offsets.mean_m;
  out["top_max_deviation"] = std::max(offsets.highest_m, -offsets.lowest_m);
  out["shape_flags"] = shapeFlags(box.shape);
  out["visible_pixels"] = capture.visible_pixels.at(index);
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
    truth["boxes"].push_back(toJson(scene.boxes[i], i, capture));
  }
  truth["objects"] = json::array();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    truth["objects"].push_back(toJson(scene.objects[i], i, capture));
  }
  truth["markers"] = allMarkers(scene);
  return truth.dump(2, ' ', true, json::error_handler_t::replace) + "\n";
}

void writeTruth(const std::string& path, const Scene& scene, const Capture& capture, std::uint64_t seed) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << truthJson(scene, capture, seed);
  file.close();
  if (!file) throw std::runtime_error(path + ": cannot write: " + std::strerror(errno));
}

void writeMask(const std::string& path, const Capture& capture) {
  if (path.size() < 4 || path.compare(path.size() - 4, 4, ".png") != 0) {
    throw std::invalid_argument("writeMask: path = '" + path + "' does not end in .png");
  }
  cv::Mat mask(capture.cloud.height, capture.cloud.width, CV_16UC1);
  std::memcpy(mask.data, capture.mask.data(), capture.mask.size() * sizeof(std::uint16_t));
  bool written = false;
  try {
    written = cv::imwrite(path, mask);
  } catch (const cv::Exception&) {  // said below
  }
  if (!written) throw std::runtime_error(path + ": cannot write the mask");
}

}  // namespace mixed_palletizing::simulation

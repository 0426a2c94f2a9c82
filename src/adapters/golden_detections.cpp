#include <cstdio>
#include <fstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include <mixed_palletizing/adapters/detections_json.hpp>
#include <mixed_palletizing/adapters/golden_detections.hpp>

namespace mixed_palletizing::adapters {
namespace {

using Json = nlohmann::json;

constexpr const char* kFormat = "mixed_palletizing golden detections 1";

Json toJson(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Eigen::Vector3d vectorFrom(const Json& json) {
  if (json.size() != 3) throw std::runtime_error("a vector has not 3 numbers");
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

Json toJson(const GoldenBox& box) {
  return {
      {"center", toJson(box.center)}, {"yaw", box.yaw_rad}, {"size", toJson(box.size)}, {"flags", box.flags}};
}

GoldenBox boxFrom(const Json& json) {
  GoldenBox box;
  box.center = vectorFrom(json.at("center"));
  box.yaw_rad = json.at("yaw").get<double>();
  box.size = vectorFrom(json.at("size"));
  box.flags = json.at("flags").get<std::vector<std::string>>();
  return box;
}

GoldenCloud cloudFrom(const Json& json) {
  GoldenCloud cloud;
  cloud.stamp_ns = json.at("stamp_ns").get<std::uint64_t>();
  cloud.fault = json.value("fault", std::string());
  for (const Json& box : json.at("boxes")) cloud.boxes.push_back(boxFrom(box));
  return cloud;
}

GoldenDetections goldenFrom(const Json& json) {
  if (json.value("format", std::string()) != kFormat) {
    throw std::runtime_error(std::string("is no golden file: \"format\" is not \"") + kFormat + "\"");
  }
  GoldenDetections golden;
  const Json& rows = json.at("base_from_camera");
  for (Eigen::Index row = 0; row < 4; ++row) {
    for (Eigen::Index col = 0; col < 4; ++col) {
      golden.base_from_camera.matrix()(row, col) =
          rows.at(static_cast<std::size_t>(row)).at(static_cast<std::size_t>(col)).get<double>();
    }
  }
  for (const Json& cloud : json.at("clouds")) golden.clouds.push_back(cloudFrom(cloud));
  return golden;
}

}  // namespace

std::vector<GoldenBox> goldenBoxes(const detection::Detections& detections) {
  std::vector<GoldenBox> boxes;
  for (const detection::DetectedBox& box : detections.boxes) {
    boxes.push_back({box.center, box.yaw_rad, box.size, flagNames(box.flags)});
  }
  return boxes;
}

std::string goldenJson(const GoldenDetections& golden) {
  Json json;
  json["format"] = kFormat;
  json["base_from_camera"] = Json::array();
  for (Eigen::Index row = 0; row < 4; ++row) {
    const Eigen::Matrix<double, 1, 4> r = golden.base_from_camera.matrix().row(row);
    json["base_from_camera"].push_back({r(0), r(1), r(2), r(3)});
  }
  json["clouds"] = Json::array();
  for (const GoldenCloud& cloud : golden.clouds) {
    Json item = {{"stamp_ns", cloud.stamp_ns}, {"boxes", Json::array()}};
    if (!cloud.fault.empty()) item["fault"] = cloud.fault;
    for (const GoldenBox& box : cloud.boxes) item["boxes"].push_back(toJson(box));
    json["clouds"].push_back(item);
  }
  return json.dump(1);
}

void writeGolden(const std::string& path, const GoldenDetections& golden) {
  const std::string temporary = path + ".part";
  std::ofstream file(temporary);
  file << goldenJson(golden) << '\n';
  file.close();
  if (!file || std::rename(temporary.c_str(), path.c_str()) != 0) {
    std::remove(temporary.c_str());
    throw std::runtime_error(path + ": cannot be written");
  }
}

GoldenDetections readGolden(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read; write it with --update");
  try {
    return goldenFrom(Json::parse(file));
  } catch (const Json::exception& error) {
    throw std::runtime_error(path + ": is no golden file: " + error.what());
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace mixed_palletizing::adapters

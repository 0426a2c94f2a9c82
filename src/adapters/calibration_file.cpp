#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <vector>

#include <Eigen/SVD>
#include <yaml-cpp/yaml.h>

#include <mixed_palletizing/adapters/calibration_file.hpp>
#include <mixed_palletizing/adapters/option_reader.hpp>

namespace mixed_palletizing::adapters {
namespace {

constexpr double kRigid = 1e-3;

/// The 16 numbers of the rows; empty when the node is anything else.
std::vector<double> numbersOf(const YAML::Node& rows) {
  std::vector<double> numbers;
  if (!rows.IsSequence() || rows.size() != 4) return {};
  for (const YAML::Node& row : rows) {
    if (!row.IsSequence() || row.size() != 4) return {};
    for (const YAML::Node& cell : row) {
      try {
        numbers.push_back(cell.as<double>());
      } catch (const YAML::Exception&) {
        return {};
      }
    }
  }
  return numbers;
}

geometry::Pose toPose(const std::vector<double>& numbers) {
  if (numbers.size() != 16)
    throw std::runtime_error("base_from_camera: four rows of four numbers are expected");
  const Eigen::Matrix4d matrix =
      Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(numbers.data());
  const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
  const bool rigid =
      matrix.allFinite() && (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm() < kRigid &&
      rotation.determinant() > 0.0 && (matrix.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).norm() < kRigid;
  if (!rigid) throw std::runtime_error("base_from_camera: not a rotation and a translation");
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(rotation, Eigen::ComputeFullU | Eigen::ComputeFullV);
  geometry::Pose pose = geometry::Pose::Identity();
  pose.linear() = svd.matrixU() * svd.matrixV().transpose();
  pose.translation() = matrix.topRightCorner<3, 1>();
  return pose;
}

std::vector<geometry::Plane> planesFrom(const std::vector<double>& numbers) {
  if (numbers.size() % 4 != 0) throw std::runtime_error("removed_planes: four numbers are expected for each");
  std::vector<geometry::Plane> planes;
  for (std::size_t i = 0; i < numbers.size(); i += 4) {
    const Eigen::Vector3d normal(numbers[i], numbers[i + 1], numbers[i + 2]);
    if (std::abs(normal.norm() - 1.0) > kRigid)
      throw std::runtime_error("removed_planes: a normal is not of length 1");
    planes.push_back({normal.normalized(), numbers[i + 3]});
  }
  return planes;
}

std::string toYaml(const Calibration& calibration) {
  YAML::Emitter out;
  out.SetDoublePrecision(17);
  out << YAML::BeginMap;
  out << YAML::Key << "base_frame" << YAML::Value << calibration.base_frame;
  out << YAML::Key << "camera_frame" << YAML::Value << calibration.camera_frame;
  out << YAML::Key << "base_from_camera" << YAML::Value << YAML::BeginSeq;
  const Eigen::Matrix4d matrix = calibration.base_from_camera.matrix();
  for (int row = 0; row < 4; ++row) {
    out << YAML::Flow << YAML::BeginSeq;
    for (int col = 0; col < 4; ++col) out << matrix(row, col);
    out << YAML::EndSeq;
  }
  out << YAML::EndSeq;
  if (!calibration.removed_planes.empty()) {
    out << YAML::Key << "removed_planes" << YAML::Value << YAML::Flow << YAML::BeginSeq;
    for (const geometry::Plane& plane : calibration.removed_planes) {
      out << plane.normal.x() << plane.normal.y() << plane.normal.z() << plane.offset;
    }
    out << YAML::EndSeq;
  }
  out << YAML::EndMap;
  return out.c_str();
}

}  // namespace

void writeCalibration(const std::string& path, const Calibration& calibration) {
  // A file that is cut short by a crash would stop the next start: write beside it and rename.
  const std::string draft = path + ".new";
  std::ofstream file(draft);
  file << "# Where the camera is: p_base = base_from_camera * p_camera, rows of the 4 x 4 matrix [m].\n"
       << toYaml(calibration) << '\n';
  file.close();
  if (!file || std::rename(draft.c_str(), path.c_str()) != 0) {
    std::remove(draft.c_str());
    throw std::runtime_error(path + ": cannot be written");
  }
}

Calibration readCalibration(const std::string& path) {
  const YAML::Node tree = loadYaml(path);
  Calibration calibration;
  try {
    OptionReader reader(tree);
    reader.read("base_frame", calibration.base_frame);
    reader.read("camera_frame", calibration.camera_frame);
    reader.ignore("base_from_camera");
    std::vector<double> planes;
    reader.read("removed_planes", planes);
    reader.finish("calibration");
    if (!tree.IsMap() || !tree["base_from_camera"]) throw std::runtime_error("base_from_camera: is missing");
    calibration.base_from_camera = toPose(numbersOf(tree["base_from_camera"]));
    calibration.removed_planes = planesFrom(planes);
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
  return calibration;
}

}  // namespace mixed_palletizing::adapters

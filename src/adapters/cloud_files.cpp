#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <vector>

#include <pcl/PCLPointCloud2.h>
#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <mixed_palletizing/adapters/cloud_files.hpp>

#include "cloud_file_headers.hpp"
#include "cloud_file_type.hpp"

namespace mixed_palletizing::adapters {
namespace {

using geometry::ColoredPoint;
using geometry::OrganizedCloud;

/// PCL reports on the console; our callers get one line by exception instead.
class QuietPcl {
 public:
  QuietPcl() : level_(pcl::console::getVerbosityLevel()) {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  }
  ~QuietPcl() { pcl::console::setVerbosityLevel(level_); }
  QuietPcl(const QuietPcl&) = delete;
  QuietPcl& operator=(const QuietPcl&) = delete;

 private:
  pcl::console::VERBOSITY_LEVEL level_;
};

pcl::PCLPointCloud2 readAny(const std::string& path) {
  const CloudFileType type = cloudFileType(path);
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(path, std::string("cannot open: ") + std::strerror(errno));
  file.seekg(0, std::ios::end);
  const auto bytes = static_cast<std::size_t>(std::max<std::streamoff>(file.tellg(), 0));
  file.seekg(0);
  const std::string problem =
      type == CloudFileType::kPcd ? pcdHeaderProblem(file, bytes) : plyHeaderProblem(file, bytes);
  if (!problem.empty()) fail(path, problem);
  pcl::PCLPointCloud2 cloud;
  int status = -1;
  try {
    const QuietPcl quiet;
    status =
        type == CloudFileType::kPcd ? pcl::PCDReader().read(path, cloud) : pcl::PLYReader().read(path, cloud);
  } catch (const std::exception& error) {  // e.g. std::bad_alloc for a header that promises too many points
    fail(path, std::string("cannot read: ") + error.what());
  }
  if (status < 0) fail(path, "damaged or truncated, or not a point cloud file");
  return cloud;
}

const pcl::PCLPointField* findField(const pcl::PCLPointCloud2& cloud, const std::string& name) {
  for (const pcl::PCLPointField& field : cloud.fields) {
    if (field.name == name) return &field;
  }
  return nullptr;
}

template <typename T>
T readAs(const std::uint8_t* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

/// Reads a coordinate of 32 or 64 bits as float.
class Coordinate {
 public:
  Coordinate(const std::string& path, const pcl::PCLPointCloud2& cloud, const std::string& name) {
    const pcl::PCLPointField* field = findField(cloud, name);
    if (field == nullptr) fail(path, "no field '" + name + "'");
    is_double_ = field->datatype == pcl::PCLPointField::FLOAT64;
    if (!is_double_ && field->datatype != pcl::PCLPointField::FLOAT32) {
      fail(path, "field '" + name + "' is not a float");
    }
    offset_ = field->offset;
  }
  float operator()(const std::uint8_t* point) const {
    return is_double_ ? static_cast<float>(readAs<double>(point + offset_)) : readAs<float>(point + offset_);
  }

 private:
  std::size_t offset_ = 0;
  bool is_double_ = false;
};

const pcl::PCLPointField* findColor(const std::string& path, const pcl::PCLPointCloud2& cloud) {
  const pcl::PCLPointField* color = findField(cloud, "rgba");
  if (color == nullptr) color = findField(cloud, "rgb");
  if (color == nullptr) return nullptr;
  const bool four_bytes = color->datatype == pcl::PCLPointField::FLOAT32 ||
                          color->datatype == pcl::PCLPointField::UINT32 ||
                          color->datatype == pcl::PCLPointField::INT32;
  if (!four_bytes) fail(path, "field '" + color->name + "' is not 4 bytes of colour");
  return color;
}

void checkGrid(const std::string& path, const pcl::PCLPointCloud2& cloud) {
  const std::size_t size = static_cast<std::size_t>(cloud.width) * cloud.height;
  if (size == 0) fail(path, "no points");
  if (cloud.height < 2 || cloud.width < 2) {
    fail(path, "not organized: " + std::to_string(cloud.width) + " x " + std::to_string(cloud.height) +
                   " points, rows and columns needed");
  }
  if (cloud.data.size() < size * cloud.point_step) fail(path, "truncated: fewer points than promised");
}

}  // namespace

OrganizedCloud readCloud(const std::string& path) {
  const pcl::PCLPointCloud2 raw = readAny(path);
  const Coordinate x(path, raw, "x");
  const Coordinate y(path, raw, "y");
  const Coordinate z(path, raw, "z");
  const pcl::PCLPointField* color = findColor(path, raw);
  checkGrid(path, raw);

  OrganizedCloud cloud;
  cloud.width = static_cast<int>(raw.width);
  cloud.height = static_cast<int>(raw.height);
  cloud.has_color = color != nullptr;
  cloud.points.resize(static_cast<std::size_t>(raw.width) * raw.height);
  const std::uint8_t* bytes = raw.data.data();
  for (ColoredPoint& point : cloud.points) {
    point.x = x(bytes);
    point.y = y(bytes);
    point.z = z(bytes);
    if (color != nullptr) point.rgba = readAs<std::uint32_t>(bytes + color->offset);
    bytes += raw.point_step;
  }
  return cloud;
}

}  // namespace mixed_palletizing::adapters

#include <algorithm>
#include <cctype>
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

namespace mixed_palletizing::adapters {
namespace {

using geometry::ColoredPoint;
using geometry::OrganizedCloud;

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw std::runtime_error(path + ": " + reason);
}

enum class Format { kPcd, kPly };

Format formatOf(const std::string& path) {
  std::string ending = path.size() < 4 ? path : path.substr(path.size() - 4);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".pcd") return Format::kPcd;
  if (ending == ".ply") return Format::kPly;
  fail(path, "neither .pcd nor .ply");
}

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
  const Format format = formatOf(path);
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(path, std::string("cannot open: ") + std::strerror(errno));
  file.seekg(0, std::ios::end);
  const auto bytes = static_cast<std::size_t>(std::max<std::streamoff>(file.tellg(), 0));
  file.seekg(0);
  const std::string problem =
      format == Format::kPcd ? pcdHeaderProblem(file, bytes) : plyHeaderProblem(file, bytes);
  if (!problem.empty()) fail(path, problem);
  pcl::PCLPointCloud2 cloud;
  int status = -1;
  try {
    const QuietPcl quiet;
    status = format == Format::kPcd ? pcl::PCDReader().read(path, cloud) : pcl::PLYReader().read(path, cloud);
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

std::string header(const OrganizedCloud& cloud, Format format) {
  const std::string width = std::to_string(cloud.width);
  const std::string height = std::to_string(cloud.height);
  const std::string count = std::to_string(cloud.points.size());
  const bool color = cloud.has_color;
  if (format == Format::kPcd) {
    return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z" +
           std::string(color ? " rgba" : "") + "\nSIZE 4 4 4" + (color ? " 4" : "") + "\nTYPE F F F" +
           (color ? " U" : "") + "\nCOUNT 1 1 1" + (color ? " 1" : "") + "\nWIDTH " + width + "\nHEIGHT " +
           height + "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count + "\nDATA binary\n";
  }
  const std::string colors =
      "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n";
  return "ply\nformat binary_little_endian 1.0\nobj_info num_cols " + width + "\nobj_info num_rows " +
         height + "\nelement vertex " + count + "\nproperty float x\nproperty float y\nproperty float z\n" +
         (color ? colors : std::string()) + "end_header\n";
}

std::vector<char> body(const OrganizedCloud& cloud, Format format) {
  const std::size_t step = cloud.has_color ? sizeof(ColoredPoint) : 3 * sizeof(float);
  std::vector<char> bytes(cloud.points.size() * step);
  char* out = bytes.data();
  for (const ColoredPoint& point : cloud.points) {
    std::memcpy(out, &point, step);
    if (cloud.has_color && format == Format::kPly) std::swap(out[12], out[14]);  // b, g, r, a -> r, g, b, a
    out += step;
  }
  return bytes;
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

void writeCloud(const std::string& path, const OrganizedCloud& cloud) {
  const Format format = formatOf(path);
  if (cloud.width < 1 || cloud.height < 1 || cloud.points.size() != cloud.view().size()) {
    throw std::invalid_argument("writeCloud: cloud has " + std::to_string(cloud.points.size()) +
                                " points for width " + std::to_string(cloud.width) + " and height " +
                                std::to_string(cloud.height));
  }
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  if (!file) fail(path, std::string("cannot open for writing: ") + std::strerror(errno));
  const std::string head = header(cloud, format);
  const std::vector<char> bytes = body(cloud, format);
  file.write(head.data(), static_cast<std::streamsize>(head.size()));
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) fail(path, std::string("cannot write: ") + std::strerror(errno));
}

}  // namespace mixed_palletizing::adapters

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <vector>

#include <mixed_palletizing/adapters/cloud_files.hpp>

#include "cloud_file_type.hpp"

namespace mixed_palletizing::adapters {
namespace {

using geometry::OrganizedCloud;

std::string pcdHeader(const OrganizedCloud& cloud, const CloudFormat& format) {
  std::string names;
  std::string sizes;
  std::string types;
  std::string counts;
  for (const CloudField& field : format.fields) {
    names += " " + field.name;
    sizes += " 4";
    types += field.is_float ? " F" : " U";
    counts += " 1";
  }
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS" + names + "\nSIZE" + sizes +
         "\nTYPE" + types + "\nCOUNT" + counts + "\nWIDTH " + std::to_string(cloud.width) + "\nHEIGHT " +
         std::to_string(cloud.height) + "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
         std::to_string(cloud.points.size()) + "\nDATA binary\n";
}

/// In PLY files colour has names of its own.
std::string plyHeader(const OrganizedCloud& cloud, const CloudFormat& format) {
  std::string properties;
  for (const CloudField& field : format.fields) {
    properties +=
        field.name.compare(0, 3, "rgb") == 0
            ? "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n"
            : "property float " + field.name + "\n";
  }
  return "ply\nformat binary_little_endian 1.0\nobj_info num_cols " + std::to_string(cloud.width) +
         "\nobj_info num_rows " + std::to_string(cloud.height) + "\nelement vertex " +
         std::to_string(cloud.points.size()) + "\n" + properties + "end_header\n";
}

/// The points without padding.
std::vector<char> body(const OrganizedCloud& cloud, CloudLayout layout, CloudFileType type) {
  const CloudFormat format = cloudFormat(layout);
  const std::vector<std::uint8_t> points = packPoints(cloud, layout);
  const std::size_t step = format.fields.size() * sizeof(float);
  std::vector<char> bytes(cloud.points.size() * step);
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    char* out = &bytes[i * step];
    std::memcpy(out, &points[i * format.point_step], step);
    const bool has_color = format.fields.back().name.compare(0, 3, "rgb") == 0;
    if (has_color && type == CloudFileType::kPly)
      std::swap(out[step - 4], out[step - 2]);  // b, g, r -> r, g, b
  }
  return bytes;
}

}  // namespace

CloudFileType cloudFileType(const std::string& path) {
  std::string ending = path.size() < 4 ? path : path.substr(path.size() - 4);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".pcd") return CloudFileType::kPcd;
  if (ending == ".ply") return CloudFileType::kPly;
  fail(path, "neither .pcd nor .ply");
}

void writeCloud(const std::string& path, const OrganizedCloud& cloud, CloudLayout layout) {
  const CloudFileType type = cloudFileType(path);
  if (cloud.width < 1 || cloud.height < 1 || cloud.points.size() != cloud.view().size()) {
    throw std::invalid_argument("writeCloud: cloud has " + std::to_string(cloud.points.size()) +
                                " points for width " + std::to_string(cloud.width) + " and height " +
                                std::to_string(cloud.height));
  }
  if (!cloud.has_color) layout = CloudLayout::kXyz;
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  if (!file) fail(path, std::string("cannot open for writing: ") + std::strerror(errno));
  const CloudFormat format = cloudFormat(layout);
  const std::string head = type == CloudFileType::kPcd ? pcdHeader(cloud, format) : plyHeader(cloud, format);
  const std::vector<char> bytes = body(cloud, layout, type);
  file.write(head.data(), static_cast<std::streamsize>(head.size()));
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) fail(path, std::string("cannot write: ") + std::strerror(errno));
}

}  // namespace mixed_palletizing::adapters

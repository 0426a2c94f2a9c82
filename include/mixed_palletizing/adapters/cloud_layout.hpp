// How the points of a cloud lie in messages and files: the layouts of the camera's drivers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <mixed_palletizing/geometry/organized_cloud.hpp>

namespace mixed_palletizing::adapters {

enum class CloudLayout : std::uint8_t {
  kXyz,             ///< x, y, z in 16 bytes
  kXyzrgbaFloat32,  ///< and the four bytes of the colour declared as a float at 12: Zivid's ROS 1 driver
  kXyzrgbaUint32,   ///< the same bytes declared as an integer: what PCL's types expect
  kXyzcrgb,         ///< Zivid's older drivers: contrast `c` at 12, `rgb` at 16, 20 bytes
};

/// Names of the layouts for options and files: xyz, xyzrgba_float32, xyzrgba_uint32, xyzcrgb.
const std::vector<std::string>& cloudLayoutNames();

/// Throws std::invalid_argument naming the layouts when there is none of that name.
CloudLayout cloudLayout(const std::string& name);

/// Likewise; "default" is none.
std::optional<CloudLayout> optionalCloudLayout(const std::string& name);

/// The words that optionalCloudLayout() knows, for the help of a tool.
std::string cloudLayoutHelp();

struct CloudField {
  std::string name;
  std::size_t offset = 0;  ///< [bytes]; each field has four
  bool is_float = true;    ///< else unsigned
};

struct CloudFormat {
  std::vector<CloudField> fields;
  std::size_t point_step = 16;  ///< [bytes]
};

CloudFormat cloudFormat(CloudLayout layout);

/// The points in that layout, height * width * point_step bytes. A contrast is made up: the luma of the colour,
/// [0, 1], 0 without data.
std::vector<std::uint8_t> packPoints(const geometry::OrganizedCloud& cloud, CloudLayout layout);

}  // namespace mixed_palletizing::adapters

// sensor_msgs/PointCloud2 <-> organized clouds of the core: validated, read in place.
#pragma once

#include <optional>
#include <string>

#include <sensor_msgs/PointCloud2.h>

#include <mixed_palletizing/adapters/cloud_layout.hpp>
#include <mixed_palletizing/geometry/cloud_view.hpp>
#include <mixed_palletizing/geometry/organized_cloud.hpp>

namespace mixed_palletizing::adapters {

/// Why a message is no usable cloud.
enum class CloudFault {
  kNone,
  kNoFrame,           ///< header.frame_id is empty
  kEmpty,             ///< width or height is 0
  kUnorganized,       ///< one row or one column
  kBigEndian,         ///< is_bigendian
  kMissingField,      ///< x, y or z
  kDoubledField,      ///< a field is listed twice
  kWrongFieldType,    ///< x, y, z other than FLOAT32, colour other than FLOAT32 or UINT32
  kWrongFieldCount,   ///< count other than 1
  kFieldOutsideStep,  ///< a field ends after point_step
  kWrongRowStep,      ///< row_step shorter than width points
  kWrongDataSize,     ///< data is not height rows long
  kNoData,            ///< not one finite point
  kMirrored,          ///< x falls with the column or y with the row
  kImplausibleScale,  ///< points behind the camera, nearer than 1 cm or farther than 50 m: not metres
};

/// Lower-case words with underscores, as in diagnostics: "wrong_row_step".
const char* toString(CloudFault fault);

/// A view into the message, or what is wrong with it.
struct CheckedCloud {
  std::optional<geometry::CloudView> view;  ///< valid as long as the message
  CloudFault fault = CloudFault::kNone;
  std::string message;  ///< the values that are wrong; empty when the cloud is good
};

/// Checks layout and content of a cloud. Fields are found by name at any offset of any point_step; colour is
/// the field `rgba`, else `rgb`, and may be missing. Content is judged by a grid of some ten thousand
/// samples, by all points only when no sample has data. Never reads outside `message.data`, whatever the
/// numbers say.
CheckedCloud checkCloud(const sensor_msgs::PointCloud2& message);

/// A message in one of the drivers' layouts; with `has_color` = false x, y, z alone. Throws std::invalid_argument
/// when `points` is not width * height long.
sensor_msgs::PointCloud2Ptr toMessage(const geometry::OrganizedCloud& cloud, const std_msgs::Header& header,
                                      CloudLayout layout = CloudLayout::kXyzrgbaFloat32);

}  // namespace mixed_palletizing::adapters

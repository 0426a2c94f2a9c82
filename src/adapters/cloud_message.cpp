#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>

#include <boost/make_shared.hpp>
#include <sensor_msgs/PointField.h>

#include <mixed_palletizing/adapters/cloud_message.hpp>

#include "cloud_content.hpp"

namespace mixed_palletizing::adapters {
namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

/// The only field with this name; null when there is none. `fault` is set when it cannot be used.
const PointField* findField(const PointCloud2& message, const std::string& name, bool is_color,
                            CheckedCloud& fault) {
  const PointField* found = nullptr;
  for (const PointField& field : message.fields) {
    if (field.name != name) continue;
    if (found != nullptr) {
      fault = faulty(CloudFault::kDoubledField, "field '" + name + "' is listed twice");
      return nullptr;
    }
    found = &field;
  }
  if (found == nullptr) return nullptr;
  const bool type_is_good =
      found->datatype == PointField::FLOAT32 || (is_color && found->datatype == PointField::UINT32);
  if (!type_is_good) {
    fault = faulty(CloudFault::kWrongFieldType, "field '" + name + "' has datatype " +
                                                    std::to_string(found->datatype) + ", not FLOAT32" +
                                                    (is_color ? " or UINT32" : ""));
  } else if (found->count != 1) {
    fault = faulty(CloudFault::kWrongFieldCount,
                   "field '" + name + "' has count " + std::to_string(found->count) + ", not 1");
  } else if (std::uint64_t{found->offset} + 4 > message.point_step) {
    fault = faulty(CloudFault::kFieldOutsideStep,
                   "field '" + name + "' at byte " + std::to_string(found->offset) +
                       " ends after point_step " + std::to_string(message.point_step));
  }
  return found;
}

/// Fills the offsets of the view.
CheckedCloud checkFields(const PointCloud2& message, geometry::CloudView& view) {
  CheckedCloud fault;
  const std::array<std::pair<const char*, std::size_t*>, 3> coordinates{
      {{"x", &view.x_offset}, {"y", &view.y_offset}, {"z", &view.z_offset}}};
  for (const auto& [name, offset] : coordinates) {
    const PointField* field = findField(message, name, false, fault);
    if (fault.fault != CloudFault::kNone) return fault;
    if (field == nullptr) {
      return faulty(CloudFault::kMissingField, std::string("there is no field '") + name + "'");
    }
    *offset = field->offset;
  }
  for (const char* name : {"rgba", "rgb"}) {
    const PointField* field = findField(message, name, true, fault);
    if (fault.fault != CloudFault::kNone) return fault;
    if (field == nullptr) continue;
    view.color_offset = field->offset;
    break;
  }
  return fault;
}

std::string sizeText(const PointCloud2& message) {
  return std::to_string(message.width) + " x " + std::to_string(message.height);
}

/// Sizes and steps; all products in 64 bits, where the largest (2^32 - 1)^2 still fits.
CheckedCloud checkLayout(const PointCloud2& message) {
  const std::uint64_t width = message.width;
  const std::uint64_t height = message.height;
  if (message.header.frame_id.empty()) return faulty(CloudFault::kNoFrame, "header.frame_id is empty");
  if (width == 0 || height == 0) return faulty(CloudFault::kEmpty, "the grid is " + sizeText(message));
  if (width == 1 || height == 1) {
    return faulty(CloudFault::kUnorganized,
                  "the grid is " + sizeText(message) + ": rows and columns of the camera are needed");
  }
  if (message.is_bigendian != 0) return faulty(CloudFault::kBigEndian, "is_bigendian is set");
  if (message.row_step < width * message.point_step) {
    return faulty(CloudFault::kWrongRowStep, "row_step " + std::to_string(message.row_step) +
                                                 " is shorter than " + std::to_string(width) + " points of " +
                                                 std::to_string(message.point_step) + " bytes");
  }
  if (std::uint64_t{message.row_step} * height != message.data.size()) {
    return faulty(CloudFault::kWrongDataSize, std::to_string(message.data.size()) + " bytes of data, not " +
                                                  std::to_string(message.row_step) + " x " +
                                                  std::to_string(height));
  }
  constexpr std::uint64_t kMaxSide = std::numeric_limits<int>::max();
  if (width > kMaxSide || height > kMaxSide) {
    return faulty(CloudFault::kWrongDataSize, "the grid " + sizeText(message) + " is too large");
  }
  return {};
}

PointField makeField(const CloudField& described) {
  PointField field;
  field.name = described.name;
  field.offset = static_cast<std::uint32_t>(described.offset);
  field.datatype = described.is_float ? PointField::FLOAT32 : PointField::UINT32;
  field.count = 1;
  return field;
}

}  // namespace

const char* toString(CloudFault fault) {
  switch (fault) {
    case CloudFault::kNone:
      return "none";
    case CloudFault::kNoFrame:
      return "no_frame";
    case CloudFault::kEmpty:
      return "empty";
    case CloudFault::kUnorganized:
      return "unorganized";
    case CloudFault::kBigEndian:
      return "big_endian";
    case CloudFault::kMissingField:
      return "missing_field";
    case CloudFault::kDoubledField:
      return "doubled_field";
    case CloudFault::kWrongFieldType:
      return "wrong_field_type";
    case CloudFault::kWrongFieldCount:
      return "wrong_field_count";
    case CloudFault::kFieldOutsideStep:
      return "field_outside_step";
    case CloudFault::kWrongRowStep:
      return "wrong_row_step";
    case CloudFault::kWrongDataSize:
      return "wrong_data_size";
    case CloudFault::kNoData:
      return "no_data";
    case CloudFault::kMirrored:
      return "mirrored";
    case CloudFault::kImplausibleScale:
      return "implausible_scale";
  }
  return "unknown";
}

CheckedCloud checkCloud(const PointCloud2& message) {
  CheckedCloud checked = checkLayout(message);
  if (checked.fault != CloudFault::kNone) return checked;
  geometry::CloudView view;
  checked = checkFields(message, view);
  if (checked.fault != CloudFault::kNone) return checked;
  view.data = message.data.data();
  view.width = static_cast<int>(message.width);
  view.height = static_cast<int>(message.height);
  view.point_step = message.point_step;
  view.row_step = message.row_step;
  checked = checkContent(view);
  if (checked.fault == CloudFault::kNone) checked.view = view;
  return checked;
}

sensor_msgs::PointCloud2Ptr toMessage(const geometry::OrganizedCloud& cloud, const std_msgs::Header& header,
                                      CloudLayout layout) {
  const std::size_t size = static_cast<std::size_t>(cloud.width) * static_cast<std::size_t>(cloud.height);
  if (cloud.width < 0 || cloud.height < 0 || cloud.points.size() != size) {
    throw std::invalid_argument("toMessage: cloud: " + std::to_string(cloud.points.size()) +
                                " points in a grid of " + std::to_string(cloud.width) + " x " +
                                std::to_string(cloud.height));
  }
  auto message = boost::make_shared<PointCloud2>();
  message->header = header;
  message->width = static_cast<std::uint32_t>(cloud.width);
  message->height = static_cast<std::uint32_t>(cloud.height);
  if (!cloud.has_color) layout = CloudLayout::kXyz;
  const CloudFormat format = cloudFormat(layout);
  for (const CloudField& field : format.fields) message->fields.push_back(makeField(field));
  message->is_bigendian = 0;
  message->is_dense = 0;
  message->point_step = static_cast<std::uint32_t>(format.point_step);
  message->row_step = message->point_step * message->width;
  message->data = packPoints(cloud, layout);
  return message;
}

}  // namespace mixed_palletizing::adapters

// Cloud messages of any numbers: refused with a reason, or detected in without a crash, by either method and in either mode.
//
// The first byte chooses the detector, and a sound message of a painted scene or one whose numbers and points are all the input's.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <stdexcept>

#include <boost/make_shared.hpp>
#include <sensor_msgs/PointCloud2.h>

#include <mixed_palletizing/adapters/cloud_message.hpp>
#include <mixed_palletizing/detection/box_detector.hpp>

namespace {

using namespace mixed_palletizing;

/// Takes numbers from the front of the bytes; zeros when they are used up.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  template <typename T>
  T take() {
    T value{};
    const std::size_t bytes = std::min(left_, sizeof(T));
    std::memcpy(&value, data_, bytes);
    skip(bytes);
    return value;
  }
  std::vector<std::uint8_t> rest() const { return {data_, data_ + left_}; }

 private:
  void skip(std::size_t bytes) {
    data_ += bytes;
    left_ -= bytes;
  }

  const std::uint8_t* data_;
  std::size_t left_;
};

/// A floor two metres away with rectangles painted on it by the input: heights, holes, slopes and noise. Random bytes
/// alone hardly ever look like a surface.
std::vector<std::uint8_t> paintedPoints(Input& input, std::uint32_t width, std::uint32_t height) {
  constexpr float kFloorM = 2.0F;
  constexpr std::uint32_t kWhole = 128;  ///< the image's sides in the input's bytes
  std::vector<float> depths(std::size_t{width} * height, kFloorM);
  const unsigned rectangles = input.take<std::uint8_t>() % 16U;
  for (unsigned i = 0; i < rectangles; ++i) {
    const std::uint32_t left = input.take<std::uint8_t>() * width / kWhole;
    const std::uint32_t top = input.take<std::uint8_t>() * height / kWhole;
    const std::uint32_t right = std::min(width, left + 1 + input.take<std::uint8_t>() * width / kWhole);
    const std::uint32_t bottom = std::min(height, top + 1 + input.take<std::uint8_t>() * height / kWhole);
    const float rise = static_cast<float>(input.take<std::int16_t>()) / 16384.0F;  // up to 2 m, to the lens
    const float slope = static_cast<float>(input.take<std::int8_t>()) / 8192.0F;   // a pixel
    const auto flags = input.take<std::uint8_t>();
    for (std::uint32_t row = top; row < bottom; ++row) {
      for (std::uint32_t col = left; col < right; ++col) {
        const bool hole = (flags & 1U) != 0 && (row * 7 + col * 13) % 5 == 0;
        const float noise = (flags & 2U) != 0 ? static_cast<float>((row * 31 + col * 17) % 7) * 1e-3F : 0.0F;
        depths[std::size_t{row} * width + col] =
            hole ? std::numeric_limits<float>::quiet_NaN()
                 : kFloorM - rise - slope * static_cast<float>(col - left) + noise;
      }
    }
  }
  std::vector<std::uint8_t> points(depths.size() * 16U);
  const float focal =
      4.0F * static_cast<float>(width);  // a narrow view: small boxes cost the sanitizers less time
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const auto col = static_cast<float>(i % width);
    const auto row = static_cast<float>(i / width);
    const float xyz[] = {depths[i] * (col - 0.5F * static_cast<float>(width)) / focal,
                         depths[i] * (row - 0.5F * static_cast<float>(height)) / focal, depths[i]};
    std::memcpy(points.data() + 16U * i, xyz, sizeof(xyz));
    std::memset(points.data() + 16U * i + 12U, 0x80, 4);
  }
  return points;
}

sensor_msgs::PointCloud2 paintedMessage(Input input) {
  sensor_msgs::PointCloud2 message;
  message.header.frame_id = "camera";
  message.width = 2U + input.take<std::uint8_t>() / 2U;  // every point costs the sanitizers time
  message.height = 2U + input.take<std::uint8_t>() / 2U;
  message.point_step = 16;
  message.row_step = message.width * message.point_step;
  for (const char* name : {"x", "y", "z", "rgba"}) {
    sensor_msgs::PointField field;
    field.name = name;
    field.offset = static_cast<std::uint32_t>(4U * message.fields.size());
    field.datatype = sensor_msgs::PointField::FLOAT32;
    field.count = 1;
    message.fields.push_back(field);
  }
  message.data = paintedPoints(input, message.width, message.height);
  return message;
}

/// Small numbers mostly: a point costs the fuzzer sixteen bytes.
std::uint32_t side(Input& input) {
  const auto value = input.take<std::uint16_t>();
  return value == 0xffffU ? 0xffffffffU : value % 257U;
}

sensor_msgs::PointCloud2 messageFrom(Input input) {
  sensor_msgs::PointCloud2 message;
  const auto flags = input.take<std::uint8_t>();
  message.header.frame_id = (flags & 1U) != 0 ? "" : "camera";
  message.is_bigendian = static_cast<std::uint8_t>((flags >> 1U) & 1U);
  message.width = side(input);
  message.height = side(input);
  message.point_step = side(input);
  message.row_step = (flags & 4U) != 0 ? input.take<std::uint32_t>() : message.width * message.point_step;
  const std::size_t field_count = input.take<std::uint8_t>() % 8U;
  static const char* const kNames[] = {"x", "y", "z", "rgba", "rgb", "intensity", "", "X"};
  for (std::size_t i = 0; i < field_count; ++i) {
    sensor_msgs::PointField field;
    field.name = kNames[input.take<std::uint8_t>() % 8U];
    field.offset = side(input);
    field.datatype = input.take<std::uint8_t>();
    field.count = input.take<std::uint8_t>();
    message.fields.push_back(field);
  }
  message.data = input.rest();
  if ((flags & 8U) == 0) {
    // The data as long as promised, the bytes repeated: else nearly every input would fail this one check.
    const std::uint64_t wanted = std::uint64_t{message.row_step} * message.height;
    if (wanted <= (1U << 20U)) {
      const std::vector<std::uint8_t> bytes = message.data;
      message.data.resize(wanted);
      for (std::size_t i = bytes.size(); !bytes.empty() && i < wanted; ++i) {
        message.data[i] = bytes[i % bytes.size()];
      }
    }
  }
  return message;
}

detection::BoxDetector detectorOf(detection::Method method, detection::Mode mode) {
  detection::DetectionOptions options;
  options.method = method;
  options.mode = mode;
  return detection::BoxDetector(options);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static detection::BoxDetector detectors[] = {
      detectorOf(detection::Method::kBest, detection::Mode::kPalletize),
      detectorOf(detection::Method::kBest, detection::Mode::kDepalletize),
      detectorOf(detection::Method::kThesis, detection::Mode::kPalletize),
  };
  Input input(data, size);
  const auto choice = input.take<std::uint8_t>();
  const bool painted = choice % 2U == 0;
  const sensor_msgs::PointCloud2 message = painted ? paintedMessage(input) : messageFrom(input);
  const adapters::CheckedCloud checked = adapters::checkCloud(message);
  if (!checked.view) return 0;
  // A camera two metres above the floor that looks down.
  geometry::Pose base_from_camera = geometry::Pose::Identity();
  base_from_camera.linear() = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  base_from_camera.translation() = Eigen::Vector3d(0.0, 0.0, 2.0);
  detectors[choice / 2U % std::size(detectors)].detect(*checked.view, base_from_camera, true);
  return 0;
}

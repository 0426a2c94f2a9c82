#include <cstring>
#include <stdexcept>

#include <mixed_palletizing/adapters/cloud_layout.hpp>

namespace mixed_palletizing::adapters {
namespace {

using geometry::ColoredPoint;

float contrastOf(const ColoredPoint& point) {
  if (!(point.z > 0.0f)) return 0.0f;
  const auto channel = [&](unsigned shift) { return static_cast<float>((point.rgba >> shift) & 0xffu); };
  return (0.299f * channel(16) + 0.587f * channel(8) + 0.114f * channel(0)) / 255.0f;
}

}  // namespace

const std::vector<std::string>& cloudLayoutNames() {
  static const std::vector<std::string> names = {"xyz", "xyzrgba_float32", "xyzrgba_uint32", "xyzcrgb"};
  return names;
}

CloudLayout cloudLayout(const std::string& name) {
  std::string all;
  for (std::size_t i = 0; i < cloudLayoutNames().size(); ++i) {
    if (name == cloudLayoutNames()[i]) return static_cast<CloudLayout>(i);
    all += (i == 0 ? "" : ", ") + cloudLayoutNames()[i];
  }
  throw std::invalid_argument("cloudLayout: name = '" + name + "' is none of " + all);
}

std::optional<CloudLayout> optionalCloudLayout(const std::string& name) {
  if (name == "default") return std::nullopt;
  return cloudLayout(name);
}

std::string cloudLayoutHelp() {
  std::string all = "default (xyzrgba, an integer in files and a float in bags)";
  for (const std::string& name : cloudLayoutNames()) all += ", " + name;
  return all;
}

CloudFormat cloudFormat(CloudLayout layout) {
  CloudFormat format{{{"x", 0, true}, {"y", 4, true}, {"z", 8, true}}, sizeof(ColoredPoint)};
  switch (layout) {
    case CloudLayout::kXyz:
      break;
    case CloudLayout::kXyzrgbaFloat32:
      format.fields.push_back({"rgba", 12, true});
      break;
    case CloudLayout::kXyzrgbaUint32:
      format.fields.push_back({"rgba", 12, false});
      break;
    case CloudLayout::kXyzcrgb:
      format.fields.push_back({"c", 12, true});
      format.fields.push_back({"rgb", 16, true});
      format.point_step = 20;
      break;
  }
  return format;
}

std::vector<std::uint8_t> packPoints(const geometry::OrganizedCloud& cloud, CloudLayout layout) {
  const std::size_t step = cloudFormat(layout).point_step;
  std::vector<std::uint8_t> bytes(cloud.points.size() * step);
  if (bytes.empty()) return bytes;
  if (layout != CloudLayout::kXyzcrgb) {
    std::memcpy(bytes.data(), cloud.points.data(), bytes.size());
    return bytes;
  }
  std::uint8_t* out = bytes.data();
  for (const ColoredPoint& point : cloud.points) {
    const float contrast = contrastOf(point);
    std::memcpy(out, &point, 12);
    std::memcpy(out + 12, &contrast, sizeof contrast);
    std::memcpy(out + 16, &point.rgba, sizeof point.rgba);
    out += step;
  }
  return bytes;
}

}  // namespace mixed_palletizing::adapters

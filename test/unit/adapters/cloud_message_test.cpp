#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <mixed_palletizing/adapters/cloud_message.hpp>

namespace mixed_palletizing::adapters {
namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A level floor 2 m below a camera that looks straight down, one point in seven without data.
geometry::OrganizedCloud floorCloud(int width = 32, int height = 20) {
  geometry::OrganizedCloud cloud;
  cloud.width = width;
  cloud.height = height;
  cloud.points.resize(static_cast<std::size_t>(width * height));
  for (int row = 0; row < height; ++row) {
    for (int col = 0; col < width; ++col) {
      const std::size_t i = static_cast<std::size_t>(row * width + col);
      if (i % 7 == 3) continue;
      cloud.points[i].x = 0.05f * (static_cast<float>(col) - 0.5f * static_cast<float>(width));
      cloud.points[i].y = 0.05f * (static_cast<float>(row) - 0.5f * static_cast<float>(height));
      cloud.points[i].z = 2.0f;
      cloud.points[i].rgba = 0xff000000u + static_cast<std::uint32_t>(i);
    }
  }
  return cloud;
}

std_msgs::Header header() {
  std_msgs::Header header;
  header.frame_id = "camera";
  return header;
}

PointCloud2 good() { return *toMessage(floorCloud(), header()); }

PointField field(const std::string& name, std::uint32_t offset, std::uint8_t type = PointField::FLOAT32) {
  PointField field;
  field.name = name;
  field.offset = offset;
  field.datatype = type;
  field.count = 1;
  return field;
}

/// The good cloud with `step` bytes a point, its coordinates at `offset` and colour behind them.
PointCloud2 moved(std::uint32_t step, std::uint32_t offset, const std::string& color_name,
                  std::uint8_t color_type, std::uint32_t row_padding = 0) {
  const PointCloud2 from = good();
  PointCloud2 to = from;
  to.point_step = step;
  to.row_step = step * to.width + row_padding;
  to.fields = {field(color_name, offset + 12, color_type), field("z", offset + 8), field("other", 0),
               field("x", offset), field("y", offset + 4)};
  to.data.assign(std::size_t{to.row_step} * to.height, 0xee);
  for (std::uint32_t row = 0; row < from.height; ++row) {
    for (std::uint32_t col = 0; col < from.width; ++col) {
      std::memcpy(&to.data[row * to.row_step + col * step + offset],
                  &from.data[(row * from.width + col) * 16], 16);
    }
  }
  return to;
}

void expectSamePoints(const geometry::CloudView& view, const geometry::OrganizedCloud& cloud) {
  ASSERT_EQ(view.width, cloud.width);
  ASSERT_EQ(view.height, cloud.height);
  for (int row = 0; row < view.height; ++row) {
    for (int col = 0; col < view.width; ++col) {
      const auto& point = cloud.points[static_cast<std::size_t>(row * view.width + col)];
      const Eigen::Vector3f seen = view.point(row, col);
      if (std::isnan(point.x)) {
        ASSERT_TRUE(std::isnan(seen.x()));
        continue;
      }
      ASSERT_EQ(seen, Eigen::Vector3f(point.x, point.y, point.z));
      ASSERT_EQ(view.bgr(row, col)[0], point.rgba & 0xffu);
    }
  }
}

TEST(CheckCloud, readsTheDriversLayoutInPlace) {
  const PointCloud2 message = good();
  EXPECT_EQ(message.point_step, 16u);
  EXPECT_EQ(message.fields.at(3).name, "rgba");
  EXPECT_EQ(message.is_dense, 0);
  const CheckedCloud checked = checkCloud(message);
  ASSERT_TRUE(checked.view) << checked.message;
  EXPECT_EQ(checked.fault, CloudFault::kNone);
  EXPECT_EQ(checked.view->data, message.data.data());
  expectSamePoints(*checked.view, floorCloud());
}

TEST(CheckCloud, findsFieldsByNameInAnyLayout) {
  for (const std::uint32_t step : {16u, 17u, 20u, 32u, 48u}) {
    for (const auto type : {PointField::FLOAT32, PointField::UINT32}) {
      for (const char* name : {"rgb", "rgba"}) {
        const PointCloud2 message = moved(step, step - 16, name, static_cast<std::uint8_t>(type), step % 3);
        const CheckedCloud checked = checkCloud(message);
        ASSERT_TRUE(checked.view) << step << " " << name << ": " << checked.message;
        expectSamePoints(*checked.view, floorCloud());
      }
    }
  }
}

TEST(CheckCloud, olderDriversWithContrastAndRgb) {
  PointCloud2 message = moved(20, 0, "c", PointField::FLOAT32);
  message.fields.push_back(field("rgb", 16));
  const CheckedCloud checked = checkCloud(message);
  ASSERT_TRUE(checked.view) << checked.message;
  EXPECT_EQ(checked.view->color_offset, 16u);
}

TEST(CheckCloud, colorMayBeMissing) {
  PointCloud2 message = good();
  message.fields.pop_back();
  const CheckedCloud checked = checkCloud(message);
  ASSERT_TRUE(checked.view);
  EXPECT_FALSE(checked.view->hasColor());
}

struct BadCloud {
  const char* name;
  CloudFault fault;
  std::function<void(PointCloud2&)> spoil;
};

/// Applies `change` to the coordinates of every point.
void forEachPoint(PointCloud2& message, const std::function<void(float*)>& change) {
  for (std::size_t at = 0; at < message.data.size(); at += message.point_step) {
    float xyz[3];
    std::memcpy(xyz, &message.data[at], sizeof xyz);
    change(xyz);
    std::memcpy(&message.data[at], xyz, sizeof xyz);
  }
}

std::vector<BadCloud> layoutFaults() {
  const auto max = std::numeric_limits<std::uint32_t>::max();
  return {
      {"no frame", CloudFault::kNoFrame, [](auto& m) { m.header.frame_id.clear(); }},
      {"width 0", CloudFault::kEmpty, [](auto& m) { m.width = 0; }},
      {"height 0", CloudFault::kEmpty, [](auto& m) { m.height = 0; }},
      {"0 x 0 without data", CloudFault::kEmpty, [](auto& m) { m.width = m.height = 0, m.data.clear(); }},
      {"one row", CloudFault::kUnorganized,
       [](auto& m) { m.width *= m.height, m.height = 1, m.row_step = m.width * m.point_step; }},
      {"one column", CloudFault::kUnorganized,
       [](auto& m) { m.height *= m.width, m.width = 1, m.row_step = m.point_step; }},
      {"big-endian", CloudFault::kBigEndian, [](auto& m) { m.is_bigendian = 1; }},
      {"no x", CloudFault::kMissingField, [](auto& m) { m.fields.erase(m.fields.begin()); }},
      {"no z", CloudFault::kMissingField, [](auto& m) { m.fields[2].name = "Z"; }},
      {"no fields", CloudFault::kMissingField, [](auto& m) { m.fields.clear(); }},
      {"x twice", CloudFault::kDoubledField, [](auto& m) { m.fields.push_back(m.fields[0]); }},
      {"rgba twice", CloudFault::kDoubledField, [](auto& m) { m.fields.push_back(m.fields[3]); }},
      {"x as double", CloudFault::kWrongFieldType,
       [](auto& m) { m.fields[0].datatype = PointField::FLOAT64; }},
      {"y as integer", CloudFault::kWrongFieldType,
       [](auto& m) { m.fields[1].datatype = PointField::INT32; }},
      {"type 0", CloudFault::kWrongFieldType, [](auto& m) { m.fields[2].datatype = 0; }},
      {"rgba as byte", CloudFault::kWrongFieldType,
       [](auto& m) { m.fields[3].datatype = PointField::UINT8; }},
      {"count 3", CloudFault::kWrongFieldCount, [](auto& m) { m.fields[0].count = 3; }},
      {"count 0", CloudFault::kWrongFieldCount, [](auto& m) { m.fields[2].count = 0; }},
      {"z past the step", CloudFault::kFieldOutsideStep, [](auto& m) { m.fields[2].offset = 13; }},
      {"offset wraps", CloudFault::kFieldOutsideStep, [=](auto& m) { m.fields[2].offset = max; }},
      {"step 0", CloudFault::kFieldOutsideStep,
       [](auto& m) { m.point_step = 0, m.row_step = 0, m.data.clear(); }},
      {"step 11", CloudFault::kFieldOutsideStep, [](auto& m) { m.point_step = 11; }},
      {"row step 0", CloudFault::kWrongRowStep, [](auto& m) { m.row_step = 0; }},
      {"stale row step", CloudFault::kWrongRowStep, [](auto& m) { m.row_step /= 2; }},
      {"step too long", CloudFault::kWrongRowStep, [=](auto& m) { m.point_step = max; }},
      {"width 2^32 - 1", CloudFault::kWrongRowStep, [=](auto& m) { m.width = max; }},
      {"all 2^32 - 1", CloudFault::kWrongRowStep,
       [=](auto& m) { m.width = m.height = m.row_step = m.point_step = max; }},
      {"height 2^32 - 1", CloudFault::kWrongDataSize, [=](auto& m) { m.height = max; }},
      {"data short by one", CloudFault::kWrongDataSize, [](auto& m) { m.data.pop_back(); }},
      {"data long by one", CloudFault::kWrongDataSize, [](auto& m) { m.data.push_back(0); }},
      {"no data", CloudFault::kWrongDataSize, [](auto& m) { m.data.clear(); }},
  };
}

std::vector<BadCloud> contentFaults() {
  const float infinity = std::numeric_limits<float>::infinity();
  const auto scaled = [](float factor) {
    return [=](PointCloud2& m) {
      forEachPoint(m, [=](float* p) {
        for (int i = 0; i < 3; ++i) p[i] *= factor;
      });
    };
  };
  const auto all = [](float value) {
    return [=](PointCloud2& m) { forEachPoint(m, [=](float* p) { p[0] = p[1] = p[2] = value; }); };
  };
  return {
      {"all NaN", CloudFault::kNoData, all(kNan)},
      {"all infinite", CloudFault::kNoData, all(infinity)},
      {"all zero", CloudFault::kImplausibleScale, all(0.0f)},
      {"all 1e38", CloudFault::kImplausibleScale, all(1e38f)},
      {"millimetres", CloudFault::kImplausibleScale, scaled(1000.0f)},
      {"behind the camera", CloudFault::kImplausibleScale,
       [](auto& m) { forEachPoint(m, [](float* p) { p[2] = -p[2]; }); }},
      {"x mirrored", CloudFault::kMirrored, [](auto& m) { forEachPoint(m, [](float* p) { p[0] = -p[0]; }); }},
      {"y mirrored", CloudFault::kMirrored, [](auto& m) { forEachPoint(m, [](float* p) { p[1] = -p[1]; }); }},
      {"turned by half", CloudFault::kMirrored,
       [](auto& m) { forEachPoint(m, [](float* p) { p[0] = -p[0], p[1] = -p[1]; }); }},
      {"transposed", CloudFault::kMirrored,
       [](auto& m) { forEachPoint(m, [](float* p) { std::swap(p[0], p[1]); }); }},
  };
}

TEST(CheckCloud, namesEveryFault) {
  std::vector<BadCloud> all = layoutFaults();
  for (const BadCloud& bad : contentFaults()) all.push_back(bad);
  for (const BadCloud& bad : all) {
    PointCloud2 message = good();
    bad.spoil(message);
    const CheckedCloud checked = checkCloud(message);
    EXPECT_FALSE(checked.view) << bad.name;
    EXPECT_EQ(toString(checked.fault), std::string(toString(bad.fault)))
        << bad.name << ": " << checked.message;
    EXPECT_FALSE(checked.message.empty()) << bad.name;
  }
}

TEST(CheckCloud, onePointWithDataIsEnough) {
  PointCloud2 message = good();
  forEachPoint(message, [](float* p) { p[0] = p[1] = p[2] = kNan; });
  const float point[3] = {0.0f, 0.0f, 1.0f};
  std::memcpy(&message.data[16 * 5], point, sizeof point);
  EXPECT_TRUE(checkCloud(message).view);
}

TEST(CheckCloud, neverReadsOutsideWhateverTheNumbersSay) {
  const unsigned seed = 11;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const std::vector<std::uint32_t> numbers{0,  1,  2,  3,   4,   11,         12,
                                           16, 20, 32, 320, 512, 0x7fffffff, 0xffffffff};
  const auto any = [&] { return numbers[random() % numbers.size()]; };
  for (int i = 0; i < 20000; ++i) {
    PointCloud2 message = good();
    for (std::uint32_t* value : {&message.width, &message.height, &message.point_step, &message.row_step}) {
      if (random() % 3 == 0) *value = any();
    }
    for (PointField& f : message.fields) {
      if (random() % 4 == 0) f.offset = any();
      if (random() % 8 == 0) f.count = any();
      if (random() % 8 == 0) f.datatype = static_cast<std::uint8_t>(random() % 12);
    }
    if (random() % 2 == 0) message.data.resize(random() % 12000);
    const CheckedCloud checked = checkCloud(message);
    EXPECT_EQ(checked.view.has_value(), checked.fault == CloudFault::kNone);
    if (!checked.view) continue;
    const geometry::CloudView& view = *checked.view;
    const std::uint8_t* last = view.at(view.height - 1, view.width - 1);
    for (const std::size_t offset : {view.x_offset, view.y_offset, view.z_offset}) {
      ASSERT_LE(last + offset + 4, message.data.data() + message.data.size());
    }
  }
}

TEST(ToMessage, refusesAGridThatDoesNotFit) {
  geometry::OrganizedCloud cloud = floorCloud();
  cloud.points.pop_back();
  EXPECT_THROW(toMessage(cloud, header()), std::invalid_argument);
  cloud.width = -32;
  EXPECT_THROW(toMessage(cloud, header()), std::invalid_argument);
}

}  // namespace
}  // namespace mixed_palletizing::adapters

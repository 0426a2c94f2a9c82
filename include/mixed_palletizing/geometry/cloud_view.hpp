// Read-only view of an organized point cloud as it lies in a message or file: no copy, fields by byte offset.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include <Eigen/Core>

namespace mixed_palletizing::geometry {

/// Organized cloud of `height` rows and `width` columns; x, y, z are little-endian float32 in metres in the
/// camera's optical frame (x right, y down, z forward). A point without data has a non-finite coordinate.
/// The memory belongs to somebody else and must outlive the view. Offsets are bytes within a point.
struct CloudView {
  static constexpr std::size_t kNoColor = static_cast<std::size_t>(-1);

  const std::uint8_t* data = nullptr;
  int width = 0;
  int height = 0;
  std::size_t point_step = 0;
  std::size_t row_step = 0;
  std::size_t x_offset = 0;
  std::size_t y_offset = 4;
  std::size_t z_offset = 8;
  std::size_t color_offset = kNoColor;  ///< four bytes b, g, r, a (the bytes of `rgb` / `rgba` fields)

  bool hasColor() const { return color_offset != kNoColor; }
  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }

  const std::uint8_t* at(int row, int col) const {
    return data + static_cast<std::size_t>(row) * row_step + static_cast<std::size_t>(col) * point_step;
  }

  /// Point at (row, col) [m], non-finite where the camera has no data. No range check.
  Eigen::Vector3f point(int row, int col) const {
    const std::uint8_t* p = at(row, col);
    return {readFloat(p + x_offset), readFloat(p + y_offset), readFloat(p + z_offset)};
  }

  /// Colour at (row, col) as bytes b, g, r; only when hasColor().
  const std::uint8_t* bgr(int row, int col) const { return at(row, col) + color_offset; }

  static float readFloat(const std::uint8_t* p) {
    float value;
    std::memcpy(&value, p, sizeof value);
    return value;
  }
};

}  // namespace mixed_palletizing::geometry

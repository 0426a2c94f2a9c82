// Pictures on faces and surfaces.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace mixed_palletizing::simulation {

/// A colour picture, row-major from its top left; 0xRRGGBB.
struct Texture {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::uint32_t> rgb;

  /// Colour (r, g, b) in [0, 255] at a share of its width from the left and of its height from the top, each
  /// cut to [0, 1]; between the centres of pixels it is interpolated.
  Eigen::Vector3f at(double share_x, double share_y) const;
};

/// Reads a picture that OpenCV can read (PNG, JPEG ...). Throws std::runtime_error "PATH: reason".
std::shared_ptr<const Texture> loadTexture(const std::string& path);

}  // namespace mixed_palletizing::simulation

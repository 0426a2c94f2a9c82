// How many pixels a flat face would cover alone.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <mixed_palletizing/simulation/pinhole.hpp>

namespace mixed_palletizing::simulation {

/// Number of pixel centres within the projection of a convex face (corners in the optical frame [m]), before an
/// image without limits; what lies behind the camera does not count. O(rows that it covers).
std::uint64_t projectedPixels(const std::vector<Eigen::Vector3d>& convex_face, const Pinhole& pinhole);

}  // namespace mixed_palletizing::simulation

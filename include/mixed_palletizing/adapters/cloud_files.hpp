// Organized clouds as PCD and PLY files.
#pragma once

#include <string>

#include <mixed_palletizing/adapters/cloud_layout.hpp>
#include <mixed_palletizing/geometry/organized_cloud.hpp>

namespace mixed_palletizing::adapters {

/// Reads an organized cloud [m, optical frame] from a `.pcd` (ascii, binary, binary_compressed) or `.ply`
/// file (ascii or binary; its grid from `obj_info num_cols / num_rows`, a camera element or a range_grid).
/// Needs the fields x, y, z as 32 or 64 bit floats; colour from `rgba` or `rgb` when there is one.
/// Throws std::runtime_error "PATH: reason" when the file is missing, truncated, of another kind, unorganized
/// (one row), without points, or without x, y, z.
geometry::OrganizedCloud readCloud(const std::string& path);

/// Writes a `.pcd` (binary) or `.ply` file (binary, with the grid) by the ending of the path, the fields of the
/// layout without padding; with `has_color` = false x, y, z alone. In a `.ply` colour is always four bytes red, green,
/// blue, alpha. Throws std::invalid_argument when `points` is not
/// width * height long, std::runtime_error "PATH: reason" when the file cannot be written.
void writeCloud(const std::string& path, const geometry::OrganizedCloud& cloud,
                CloudLayout layout = CloudLayout::kXyzrgbaUint32);

}  // namespace mixed_palletizing::adapters

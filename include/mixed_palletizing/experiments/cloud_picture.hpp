// The colour image in an organized cloud, for the reports.
#pragma once

#include <string>

#include <mixed_palletizing/geometry/organized_cloud.hpp>

namespace mixed_palletizing::experiments {

/// Writes the colours as a picture (.png or .jpg); pixels without data are darkened, so that one sees what
/// the detector does not. Throws std::runtime_error "PATH: reason", std::invalid_argument for another ending.
void writePicture(const std::string& path, const geometry::OrganizedCloud& cloud);

}  // namespace mixed_palletizing::experiments

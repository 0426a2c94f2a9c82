// Whether the points of a well-formed cloud can be those of a camera.
#pragma once

#include <string>

#include <mixed_palletizing/adapters/cloud_message.hpp>

namespace mixed_palletizing::adapters {

/// Looks at a grid of samples: data at all, depth in metres, directions that follow rows and columns.
CheckedCloud checkContent(const geometry::CloudView& view);

inline CheckedCloud faulty(CloudFault fault, const std::string& message) {
  CheckedCloud checked;
  checked.fault = fault;
  checked.message = message;
  return checked;
}

}  // namespace mixed_palletizing::adapters

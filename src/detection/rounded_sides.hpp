// Sides with rounded edges: the surface bends down before the face is reached.
#pragma once

#include <vector>

#include "rectangle_fit.hpp"

namespace mixed_palletizing::detection {

/// Moves the sides of a fit from the end of the surface outwards onto their faces. A face in view is measured below
/// the edge, and with it the radius; edges whose face is not in view are taken to have the radius of the others, or
/// what the ray that touches them says.
void moveOntoFaces(const std::vector<EdgeSample>& samples, const FitScale& scale, FitBuffers& buffers,
                   RectangleFit& fit);

}  // namespace mixed_palletizing::detection

#include <mixed_palletizing/detection/detections.hpp>

namespace mixed_palletizing::detection {

const char* toString(RejectReason reason) {
  switch (reason) {
    case RejectReason::kTooFewPoints:
      return "too few points";
    case RejectReason::kTooSmall:
      return "too small";
    case RejectReason::kTooLarge:
      return "too large";
    case RejectReason::kNoTopPlane:
      return "no top plane";
    case RejectReason::kNotRectangular:
      return "not rectangular";
  }
  return "unknown";
}

}  // namespace mixed_palletizing::detection

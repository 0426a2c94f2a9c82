// Regression of the detector over a bag.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <mixed_palletizing/adapters/golden_detections.hpp>
#include <mixed_palletizing/adapters/offline_detection.hpp>

namespace mixed_palletizing::adapters {

struct BagRegression {
  OfflineDetectionRequest request;  ///< bag, topic, base frame, parameters
  std::string golden;               ///< golden file
  GoldenTolerances tolerances;
  std::string pictures;  ///< folder for a picture of every changed cloud; empty: none. Made when missing
};

struct BagRegressionOutcome {
  std::size_t clouds = 0;
  std::vector<std::string> lines;  ///< "cloud 3 at 12.500 s: ..."; empty when nothing differs
};

/// Writes the golden file; answers the number of clouds. Throws as replayOffline() and writeGolden().
std::size_t updateGolden(const BagRegression& job);

/// Compares the bag with the golden file. Throws as replayOffline(), readGolden(), compareGolden() and
/// writeDetectionPicture().
BagRegressionOutcome compareWithGolden(const BagRegression& job);

}  // namespace mixed_palletizing::adapters

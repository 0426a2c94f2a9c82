// Options of the detection from YAML or from the parameter server's tree.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <mixed_palletizing/adapters/option_reader.hpp>
#include <mixed_palletizing/detection/options.hpp>

namespace mixed_palletizing::adapters {

/// The words for the methods, in files and on command lines.
const std::vector<std::pair<std::string, detection::Method>>& detectionMethods();

/// The words for the modes.
const std::vector<std::pair<std::string, detection::Mode>>& detectionModes();

/// Reads method, mode and every key of the sections plane, marker, noise, cluster, top, box, stack, region; absent keys keep the value that
/// `options` has. Broken rules become problems of the reader, whose finish() throws them all at once.
void readDetectionOptions(OptionReader& reader, detection::DetectionOptions& options);

}  // namespace mixed_palletizing::adapters

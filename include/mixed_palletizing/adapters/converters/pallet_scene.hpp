// The pallet and what stands on it as obstacles for MoveIt.
#pragma once

#include <set>
#include <string>
#include <vector>

#include <moveit_msgs/PlanningScene.h>
#include <yaml-cpp/yaml.h>

#include <mixed_palletizing/PalletState.h>

namespace mixed_palletizing::converters {

struct PalletSceneOptions {
  double carrier_height_m = 0.144;  ///< of the pallet itself, below z = 0; that of a Euro pallet
};

/// Every broken rule as one line "key: what is wrong".
std::vector<std::string> problems(const PalletSceneOptions& options);

/// Throws std::invalid_argument with everything that is wrong: unknown keys, wrong types, broken rules.
PalletSceneOptions readPalletSceneOptions(const YAML::Node& tree);

/// Turns the states of one pallet into differences of a planning scene. Objects are in the pallet's frame F and
/// named F_carrier, F_box_1, F_box_2, ... in loading order; their type's key is the order line of the box.
class PalletScene {
 public:
  explicit PalletScene(const PalletSceneOptions& options);

  /// What to publish, in this order: what is gone since the state before, if anything is; then all that is there
  /// now, so that whoever hears the last message alone knows the whole pallet.
  std::vector<moveit_msgs::PlanningScene> update(const PalletState& state);

 private:
  PalletSceneOptions options_;
  std::string frame_;
  std::set<std::string> known_;  // ids that the scene holds
};

}  // namespace mixed_palletizing::converters

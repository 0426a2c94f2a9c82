// The order that a pallet is started with.
#pragma once

#include <string>

#include <mixed_palletizing/StartPallet.h>

namespace mixed_palletizing::rviz_panel {

/// Order number `index`, from 0, of a file of JSON lines. Throws std::exception whose message is for people.
StartPalletRequest readOrder(const std::string& path, int index);

}  // namespace mixed_palletizing::rviz_panel

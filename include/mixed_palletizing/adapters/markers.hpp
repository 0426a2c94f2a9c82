// Pictures of boxes and pallets for rviz.
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <mixed_palletizing/BoxArray.h>
#include <mixed_palletizing/PalletState.h>

namespace mixed_palletizing::adapters {

/// Namespaces: `boxes` (solids; green, yellow when flagged, orange when the flags say that the size is not that of
/// the whole box), `outlines`, `uncertainty` (edges of a solid around the box that two standard deviations of its
/// sides reach), `labels` (id, size in millimetres, flags), `uncertainty_labels` (two standard deviations of length,
/// width and height in millimetres), `rejected` (extent of refused clusters), `rejected_labels` (their reason). Starts with DELETEALL.
visualization_msgs::MarkerArrayPtr boxMarkers(const BoxArray& boxes);

/// Namespaces: `pallet` (the carrier below z = 0), `volume` (limits of the packing volume), `placed`,
/// `placed_outlines`, `placed_labels`, `spaces` (floors of the supported spaces), `next` (ghost of the
/// pending placement), `next_approach` (arrow), `center_of_gravity`, `title`. Only DELETEALL when no pallet
/// is open.
visualization_msgs::MarkerArrayPtr palletMarkers(const PalletState& state);

}  // namespace mixed_palletizing::adapters

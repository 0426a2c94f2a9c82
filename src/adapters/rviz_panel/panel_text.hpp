// What the panel tells people, as plain text.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <mixed_palletizing/Calibrate.h>
#include <mixed_palletizing/ChooseNextPick.h>
#include <mixed_palletizing/ClosePallet.h>
#include <mixed_palletizing/DetectBoxes.h>
#include <mixed_palletizing/PalletState.h>
#include <mixed_palletizing/PickDecision.h>

namespace mixed_palletizing::rviz_panel {

/// Boxes of the order: in all, placed, discarded.
struct OrderProgress {
  std::size_t total = 0;
  std::size_t placed = 0;
  std::size_t discarded = 0;
};

OrderProgress orderProgress(const PalletState& state);

/// "pallet p: 3 of 24 placed, 1 discarded", or that none is open.
std::string palletLine(const PalletState& state);

/// "3 boxes, 1 group of points is no box, 84 ms", or why there are none.
std::string detectLine(const DetectBoxesResponse& answer);

/// The message and what the calibration is worth.
std::string calibrateLine(const CalibrateResponse& answer);

/// Which box, the message and the time.
std::string chooseLine(const ChooseNextPickResponse& answer);

/// The message and what became of the pallet.
std::string closeLine(const ClosePalletResponse& answer);

constexpr std::array<const char*, 6> kOptionTitles{"box", "type", "place [mm]", "cost", "futures", "perfect"};
constexpr std::array<const char*, kOptionTitles.size()> kOptionHints{
    "Which of the boxes that were offered, as labelled in the view; the chosen one is bold",
    "Line of the order that it was matched to",
    "Corner of its place nearest the pallet's origin: x, y, z; or why it cannot be placed",
    "Share of the volume that stays empty in the end, as expected: less is better",
    "How often the rest of the order was played out for it",
    "Share of these that left nothing over"};

/// One row below kOptionTitles for every option; what refuses a box stands in the place's column.
std::vector<std::array<std::string, kOptionTitles.size()>> optionRows(const PickDecision& decision);

}  // namespace mixed_palletizing::rviz_panel

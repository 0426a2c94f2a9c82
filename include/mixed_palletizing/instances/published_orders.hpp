// Orders in published formats, and one door to all formats.
#pragma once

#include <optional>
#include <string>

#include <mixed_palletizing/instances/files.hpp>

namespace mixed_palletizing::instances {

enum class OrderFormat {
  kJsonLines,  ///< one instance a line
  kBr,         ///< BR text file
  kCsv,        ///< order CSV
  kBedBpp,     ///< JSON of the BED-BPP benchmark
};

/// Parses "jsonl", "br", "csv" or "bed_bpp"; std::nullopt for another word.
std::optional<OrderFormat> orderFormatFromString(const std::string& word);

/// What the order CSV does not say.
struct CsvRules {
  packing::PalletRules rules{{1200, 800, 1400}};
  packing::Rotations rotations = packing::Rotations::yawOnly();
};

/// All orders of a CSV file with the columns Order, Product, Quantity, Length, Width, Height [mm] and,
/// optionally, Weight [kg] in any sequence, one product of one order a line. Lengths are rounded up to whole
/// millimetres. An order with a faulty line is left out. Throws std::runtime_error when the file cannot be
/// read and std::invalid_argument for broken `csv.rules`.
InstanceFile readOrderCsv(const std::string& path, const CsvRules& csv = {});

/// All orders of a BED-BPP file (Kagerer et al. 2023): one JSON object with "item_sequence" and "properties"
/// for each order. Boxes stay upright and may be turned; the item sequence is the arrival; targets are
/// "euro-pallet" (1200 x 800 mm) and "rollcontainer" (800 x 700 mm), 2000 mm high. Faults name the line where
/// their order begins. Throws std::runtime_error when the file cannot be read.
InstanceFile readBedBppFile(const std::string& path);

/// Reads a file of any format; `csv` matters to kCsv only.
InstanceFile readOrders(const std::string& path, OrderFormat format, const CsvRules& csv = {});

}  // namespace mixed_palletizing::instances

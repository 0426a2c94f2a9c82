// What became of an order, pick by pick: as lines for people and as a JSON file.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <mixed_palletizing/Box.h>
#include <mixed_palletizing/Placement.h>
#include <mixed_palletizing/instances/instance.hpp>

namespace mixed_palletizing::cell {

/// A box as it was measured [mm]: length >= width, height.
struct MeasuredSize {
  std::array<double, 3> size_mm{};
  std::array<double, 3> stddev_mm{};
};

MeasuredSize measuredSize(const Box& box);

/// Length, width and height [mm] of a type as it stands before the camera: of its sides, the one as height that fits
/// the measured size best.
std::array<double, 3> standingSize(const packing::Vec3& size_mm, const MeasuredSize& measured);

struct PickRecord {
  std::string type_id;
  std::uint32_t item = 0;             ///< index in the sequence of arrival, as the simulated cell knows it
  std::array<double, 3> origin_mm{};  ///< corner nearest the pallet's origin
  std::array<double, 3> placed_size_mm{};  ///< along the pallet's x, y, z
  MeasuredSize measured;
  std::array<double, 3> nominal_mm{};  ///< standingSize() of the type
  std::uint64_t decision_id = 0;
  std::size_t available = 0;  ///< detected boxes to choose from
  double capture_ms = 0.0;
  double detection_ms = 0.0;
  double decision_ms = 0.0;
  double utilization = 0.0;  ///< after this pick, [0, 1]
};

/// What a detected box and its place say; `nominal_mm` is the size of its type.
PickRecord pickRecord(const Box& box, const Placement& placement, const packing::Vec3& nominal_mm);

struct DiscardRecord {
  std::string type_id;  ///< empty when the box was not identified
  std::string reason;
  MeasuredSize measured;   ///< zeros for what was not even detected as a box
  std::uint32_t item = 0;  ///< as in PickRecord
};

struct CellReport {
  std::string pallet_id;
  bool complete = false;
  std::string message;  ///< why it is not complete
  std::vector<PickRecord> picks;
  std::vector<DiscardRecord> discards;
  double utilization = 0.0;  ///< packed volume over the packing volume, [0, 1]
  std::vector<double> capture_ms;
  std::vector<double> detection_ms;
  std::vector<double> decision_ms;
};

/// "[ 3/24] 300x400x200 -> (600, 400, 0) as 300 x 400 x 200 mm, 1 of 3 boxes in 41 ms, utilization 12.5 %"
std::string progressLine(const PickRecord& pick, std::size_t done, std::size_t total);

/// Placed, discarded, utilization and times, a line each.
std::vector<std::string> summaryLines(const CellReport& report);

/// The JSON object described in docs/cell_report.md, over several lines.
std::string reportJson(const CellReport& report, const instances::Instance& instance);

/// Makes the folder of the report and removes a report of before. Throws std::runtime_error "PATH: reason" when no
/// file can be written there.
void prepareReport(const std::string& path);

/// Writes beside the file first and then puts it in its place, so that nobody reads half a report. Throws
/// std::runtime_error "PATH: reason".
void writeReport(const std::string& path, const std::string& text);

}  // namespace mixed_palletizing::cell

// The options by which tools name a file of orders and its format.
#pragma once

#include <string>
#include <vector>

#include <mixed_palletizing/adapters/command_line.hpp>
#include <mixed_palletizing/instances/published_orders.hpp>

namespace mixed_palletizing::adapters {

/// Declares --instances, --format and what a format leaves open, then reads the file.
class OrderFileOptions {
 public:
  /// Must outlive the parsing by `line`.
  void declare(CommandLine& line);

  /// After parsing. Errors as instances::readOrders(); std::invalid_argument for options that contradict.
  instances::InstanceFile read() const;

  /// The same, but faults throw std::invalid_argument unless `keep_going`; then they go to stderr, one a line
  /// behind `tool`.
  instances::InstanceFile readSound(const std::string& tool, bool keep_going) const;

  instances::OrderFormat format() const { return *instances::orderFormatFromString(format_); }

 private:
  void refuseWhatTheFormatSays() const;

  std::string path_;
  std::string format_ = "jsonl";
  std::vector<int> pallet_mm_{1200, 800, 1400};
  std::string rotations_ = "yaw";
  double min_support_ratio_ = 1.0;
  double max_weight_kg_ = 0.0;
  int gap_mm_ = 0;
  int overhang_mm_ = 0;
  const CommandLine* line_ = nullptr;
};

}  // namespace mixed_palletizing::adapters

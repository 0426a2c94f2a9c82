#include <iostream>
#include <stdexcept>

#include <mixed_palletizing/adapters/order_files.hpp>

namespace mixed_palletizing::adapters {

void OrderFileOptions::declare(CommandLine& line) {
  line_ = &line;
  line.required("instances", &path_, "orders");
  line.choice("format", &format_, {"jsonl", "br", "csv", "bed_bpp"}, "of the orders");
  line.option("pallet_mm", &pallet_mm_, "csv: length, width and height of the packing volume [mm]");
  line.choice("rotations", &rotations_, {"none", "yaw", "any"}, "csv: how the items may be turned");
  line.option("min_support_ratio", &min_support_ratio_,
              "csv, bed_bpp: share of a base that must be supported");
  line.option("max_weight_kg", &max_weight_kg_, "csv, bed_bpp: of all boxes on a pallet; 0 = no limit");
  line.option("gap_mm", &gap_mm_, "csv, bed_bpp: free space beside every box [mm]");
  line.option("overhang_mm", &overhang_mm_,
              "csv, bed_bpp: over the pallet's sides [mm]; needs a ratio below 1");
}

void OrderFileOptions::refuseWhatTheFormatSays() const {
  const bool csv = format() == instances::OrderFormat::kCsv;
  const bool bed_bpp = format() == instances::OrderFormat::kBedBpp;
  const auto refuse = [this](const char* name, bool goes_with) {
    if (goes_with || !line_->given(name)) return;
    throw std::invalid_argument("--" + std::string(name) + ": --format " + format_ + " says it itself");
  };
  for (const char* name : {"pallet_mm", "rotations"}) refuse(name, csv);
  for (const char* name : {"min_support_ratio", "max_weight_kg", "gap_mm", "overhang_mm"}) {
    refuse(name, csv || bed_bpp);
  }
}

instances::InstanceFile OrderFileOptions::read() const {
  refuseWhatTheFormatSays();
  instances::CsvRules csv;
  if (pallet_mm_.size() != 3) throw std::invalid_argument("--pallet_mm: three numbers are needed");
  csv.rules.size = {pallet_mm_[0], pallet_mm_[1], pallet_mm_[2]};
  if (rotations_ == "none") csv.rotations = packing::Rotations::none();
  if (rotations_ == "any") csv.rotations = packing::Rotations::any();
  instances::InstanceFile file = instances::readOrders(path_, format(), csv);
  if (format() != instances::OrderFormat::kCsv && format() != instances::OrderFormat::kBedBpp) return file;
  for (instances::Instance& instance : file.instances) {
    packing::PalletRules& rules = instance.order.rules;
    rules.min_support_ratio = min_support_ratio_;
    rules.max_weight_kg = max_weight_kg_;
    rules.gap = gap_mm_;
    rules.overhang = overhang_mm_;
    const std::vector<std::string> broken = instances::problems(instance);
    if (!broken.empty()) throw std::invalid_argument(instance.name + ": " + instances::joinFaults(broken));
  }
  return file;
}

instances::InstanceFile OrderFileOptions::readSound(const std::string& tool, bool keep_going) const {
  instances::InstanceFile file = read();
  if (!keep_going && !file.faults.empty()) throw std::invalid_argument(instances::joinFaults(file.faults));
  for (const std::string& fault : file.faults) std::cerr << tool << ": " << fault << '\n';
  return file;
}

}  // namespace mixed_palletizing::adapters

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
}

instances::InstanceFile OrderFileOptions::read() const {
  const instances::OrderFormat given = format();
  for (const char* name : {"pallet_mm", "rotations"}) {
    if (given != instances::OrderFormat::kCsv && line_->given(name)) {
      throw std::invalid_argument("--" + std::string(name) + ": goes with --format csv only; --format " +
                                  format_ + " says it itself");
    }
  }
  instances::CsvRules csv;
  if (pallet_mm_.size() != 3) throw std::invalid_argument("--pallet_mm: three numbers are needed");
  csv.rules.size = {pallet_mm_[0], pallet_mm_[1], pallet_mm_[2]};
  if (rotations_ == "none") csv.rotations = packing::Rotations::none();
  if (rotations_ == "any") csv.rotations = packing::Rotations::any();
  return instances::readOrders(path_, given, csv);
}

instances::InstanceFile OrderFileOptions::readSound(const std::string& tool, bool keep_going) const {
  instances::InstanceFile file = read();
  if (!keep_going && !file.faults.empty()) throw std::invalid_argument(instances::joinFaults(file.faults));
  for (const std::string& fault : file.faults) std::cerr << tool << ": " << fault << '\n';
  return file;
}

}  // namespace mixed_palletizing::adapters

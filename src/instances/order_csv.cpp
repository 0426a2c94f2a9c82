// Orders as a table, one product of one order a line:
//   Order,Product,Quantity,Length,Width,Height,Weight
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <stdexcept>

#include <mixed_palletizing/instances/published_orders.hpp>

#include "text_lines.hpp"

namespace mixed_palletizing::instances {
namespace {

enum Column : std::size_t { kOrder, kProduct, kQuantity, kLength, kWidth, kHeight, kWeight, kColumns };
const std::array<std::string, kColumns> kNames{"Order", "Product", "Quantity", "Length",
                                               "Width", "Height",  "Weight"};

/// Longest text quoted in a fault.
constexpr std::size_t kMaxQuote = 40;

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    const std::string cell = line.substr(begin, end - begin);
    const std::size_t first = cell.find_first_not_of(" \t");
    const std::size_t last = cell.find_last_not_of(" \t");
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
    begin = end + 1;
  }
  return cells;
}

/// A decimal number in [min, max]; `what` names it in the fault.
double numberOf(const std::string& cell, const std::string& what, double min, double max) {
  char* end = nullptr;
  const double value = std::strtod(cell.c_str(), &end);
  if (cell.empty() || *end != '\0' || !(value >= min && value <= max)) {
    throw std::invalid_argument(what + ": a number from " + std::to_string(std::llround(min)) + " to " +
                                std::to_string(std::llround(max)) + " is needed, not '" +
                                cell.substr(0, kMaxQuote) + "'");
  }
  return value;
}

class CsvReader {
 public:
  explicit CsvReader(const CsvRules& csv) : csv_(csv) {}

  void takeHeader(const std::string& line) {
    const std::string bom = "\xEF\xBB\xBF";
    const std::vector<std::string> cells = cellsOf(line.rfind(bom, 0) == 0 ? line.substr(bom.size()) : line);
    column_count_ = cells.size();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto name = std::find(kNames.begin(), kNames.end(), cells[i]);
      if (name == kNames.end()) throw std::invalid_argument("column '" + cells[i] + "' is not known");
      int& place = places_[static_cast<std::size_t>(name - kNames.begin())];
      if (place >= 0) throw std::invalid_argument("column '" + cells[i] + "' occurs twice");
      place = static_cast<int>(i);
    }
    for (std::size_t c = 0; c < kColumns; ++c) {
      if (places_[c] < 0 && c != kWeight)
        throw std::invalid_argument("column '" + kNames[c] + "' is missing");
    }
    has_header_ = true;
  }

  bool hasHeader() const { return has_header_; }

  void takeLine(const std::string& line) {
    const std::vector<std::string> cells = cellsOf(line);
    const std::string& order = places_[kOrder] < static_cast<int>(cells.size())
                                   ? cells[static_cast<std::size_t>(places_[kOrder])]
                                   : cells.front();
    try {
      takeProduct(order, cells);
    } catch (const std::invalid_argument&) {
      faulty_.insert(order);
      throw;
    }
  }

  std::vector<Instance> takeInstances() {
    std::vector<Instance> sound;
    for (Instance& instance : instances_) {
      if (faulty_.count(instance.name) == 0) sound.push_back(std::move(instance));
    }
    return sound;
  }

 private:
  void takeProduct(const std::string& order_name, const std::vector<std::string>& cells) {
    if (cells.size() != column_count_) {
      throw std::invalid_argument(std::to_string(cells.size()) + " values in the line, " +
                                  std::to_string(column_count_) + " needed");
    }
    const auto cell = [&](Column column) { return cells[static_cast<std::size_t>(places_[column])]; };
    for (const std::string& value : cells) {
      if (value.find('"') != std::string::npos)
        throw std::invalid_argument("quotes are not part of the format");
    }
    if (order_name.empty()) throw std::invalid_argument("Order: must not be empty");
    packing::ItemType type;
    type.name = cell(kProduct);
    if (type.name.empty()) throw std::invalid_argument("Product: must not be empty");
    const double count = numberOf(cell(kQuantity), "Quantity", 1.0, packing::kMaxItems);
    if (count != std::floor(count)) throw std::invalid_argument("Quantity: must be a whole number");
    type.size = {length(cell(kLength), kLength), length(cell(kWidth), kWidth),
                 length(cell(kHeight), kHeight)};
    type.rotations = csv_.rotations;
    if (places_[kWeight] >= 0) type.weight_kg = numberOf(cell(kWeight), "Weight", 0.0, kMaxWeight);
    Instance& instance = instanceOf(order_name);
    for (const packing::ItemType& other : instance.order.types) {
      if (other.name == type.name) {
        throw std::invalid_argument("Product: '" + type.name + "' occurs twice in order '" + order_name +
                                    "'");
      }
    }
    packing::Order alone{csv_.rules, {type}, {static_cast<int>(count)}};
    const std::vector<std::string> found = packing::problems(alone);
    if (!found.empty()) throw std::invalid_argument(joinFaults(found));
    if (instance.order.itemCount() + alone.counts[0] > packing::kMaxItems) {
      throw std::invalid_argument("Quantity: more than " + std::to_string(packing::kMaxItems) +
                                  " items in order '" + order_name + "'");
    }
    instance.order.types.push_back(type);
    instance.order.counts.push_back(alone.counts[0]);
  }

  static int length(const std::string& cell, Column column) {
    const double value = numberOf(cell, kNames[column], 0.0, packing::kMaxPalletLength);
    if (value <= 0.0) throw std::invalid_argument(kNames[column] + ": must be positive");
    return static_cast<int>(std::ceil(value));
  }

  Instance& instanceOf(const std::string& name) {
    const auto [found, is_new] = index_of_.emplace(name, instances_.size());
    if (is_new) {
      instances_.emplace_back();
      instances_.back().name = name;
      instances_.back().order.rules = csv_.rules;
    }
    return instances_[found->second];
  }

  static constexpr double kMaxWeight = 1e6;  ///< [kg]

  const CsvRules& csv_;
  std::array<int, kColumns> places_{-1, -1, -1, -1, -1, -1, -1};
  std::size_t column_count_ = 0;
  bool has_header_ = false;
  std::vector<Instance> instances_;
  std::map<std::string, std::size_t> index_of_;
  std::set<std::string> faulty_;
};

}  // namespace

InstanceFile readOrderCsv(const std::string& path, const CsvRules& csv) {
  const std::vector<std::string> broken = packing::problems(csv.rules);
  if (!broken.empty()) throw std::invalid_argument("readOrderCsv: csv: " + joinFaults(broken));
  InstanceFile file;
  CsvReader reader(csv);
  bool bad_header = false;
  forEachLine(path, file.faults, [&](const std::string& line, int, std::vector<std::string>&) {
    if (bad_header) return;
    if (reader.hasHeader()) return reader.takeLine(line);
    bad_header = true;  // unless the next line says otherwise
    reader.takeHeader(line);
    bad_header = false;
  });
  file.instances = reader.takeInstances();
  if (file.faults.empty() && file.instances.empty()) file.faults.push_back(path + ": holds no order");
  return file;
}

}  // namespace mixed_palletizing::instances

// The text format of the container loading classes of Bischoff and Ratcliff (1995): the number of instances,
// and for each of them
//   id seed
//   L W H                              [cm]
//   number of types
//   id l rot w rot h rot count         [cm], rot = 1: that side may stand vertical
#include <array>
#include <sstream>
#include <stdexcept>

#include <mixed_palletizing/instances/files.hpp>

#include "text_lines.hpp"

namespace mixed_palletizing::instances {
namespace {

constexpr int kMmPerCm = 10;
constexpr long long kMaxNumber = 1000000000000LL;

/// Exactly `count` integers.
std::vector<long long> integersOf(const std::string& line, std::size_t count) {
  std::istringstream in(line);
  std::vector<long long> numbers;
  for (std::string word; in >> word;) {
    std::size_t used = 0;
    long long number = -1;
    try {
      number = std::stoll(word, &used);
    } catch (const std::logic_error&) {
      used = 0;
    }
    if (used != word.size() || number < 0 || number > kMaxNumber) {
      throw std::invalid_argument("'" + word.substr(0, 40) + "' is no number of the format");
    }
    numbers.push_back(number);
  }
  if (numbers.size() != count) {
    throw std::invalid_argument(std::to_string(numbers.size()) + " numbers in the line, " +
                                std::to_string(count) + " needed");
  }
  return numbers;
}

int millimetres(long long centimetres) {
  if (centimetres < 1 || centimetres > packing::kMaxPalletLength / kMmPerCm) {
    throw std::invalid_argument("length of " + std::to_string(centimetres) + " cm: must be 1 to " +
                                std::to_string(packing::kMaxPalletLength / kMmPerCm));
  }
  return static_cast<int>(centimetres) * kMmPerCm;
}

packing::Vec3 size(long long x, long long y, long long z) {
  return {millimetres(x), millimetres(y), millimetres(z)};
}

class BrReader {
 public:
  explicit BrReader(std::string stem) : stem_(std::move(stem)) {}

  /// A fault in a value spoils its instance; a line of another shape ends the reading, as the lines after it cannot be
  /// told apart.
  void take(const std::string& line) {
    lost_ = true;
    takeLine(line);
    lost_ = false;
  }

  /// Of the last line: throws its fault.
  void throwFault() const {
    if (!fault_.empty()) throw std::invalid_argument(fault_);
  }

  bool lost() const { return lost_; }
  bool complete() const { return expected_ == Line::kEnd; }
  std::vector<Instance> takeInstances() { return std::move(instances_); }

 private:
  enum class Line { kInstanceCount, kId, kContainer, kTypeCount, kType, kEnd };

  /// Keeps the fault that `read` throws.
  template <typename Read>
  void judge(const Read& read) {
    try {
      read();
    } catch (const std::invalid_argument& error) {
      fault_ = error.what();
      sound_ = false;
    }
  }

  void takeLine(const std::string& line) {
    fault_.clear();
    switch (expected_) {
      case Line::kInstanceCount:
        instances_left_ = integersOf(line, 1)[0];
        expected_ = instances_left_ > 0 ? Line::kId : Line::kEnd;
        break;
      case Line::kId:
        instance_ = Instance();
        sound_ = true;
        instance_.name = stem_ + "_" + std::to_string(integersOf(line, 2)[0]);
        expected_ = Line::kContainer;
        break;
      case Line::kContainer: {
        const auto n = integersOf(line, 3);
        expected_ = Line::kTypeCount;
        judge([&] { instance_.order.rules.size = size(n[0], n[1], n[2]); });
        break;
      }
      case Line::kTypeCount:
        types_left_ = integersOf(line, 1)[0];
        if (types_left_ < 1) throw std::invalid_argument("an instance needs at least one type");
        expected_ = Line::kType;
        break;
      case Line::kType:
        takeType(line);
        break;
      case Line::kEnd:
        throw std::invalid_argument("more lines than instances");
    }
  }

  void takeType(const std::string& line) {
    const auto n = integersOf(line, 8);
    judge([&] { addType(n); });
    if (--types_left_ > 0) return;
    expected_ = --instances_left_ > 0 ? Line::kId : Line::kEnd;
    if (!sound_) return;
    const std::vector<std::string> found = problems(instance_);
    if (found.empty()) {
      instances_.push_back(instance_);
    } else {
      fault_ = instance_.name + ": " + joinFaults(found);
    }
  }

  void addType(const std::vector<long long>& n) {
    packing::ItemType type;
    type.name = "t" + std::to_string(n[0]);
    type.size = size(n[1], n[3], n[5]);
    type.rotations = {true, {n[2] != 0, n[4] != 0, n[6] != 0}};
    if (n[7] < 1 || n[7] > packing::kMaxItems) {
      throw std::invalid_argument("count of " + std::to_string(n[7]) + ": must be 1 to " +
                                  std::to_string(packing::kMaxItems));
    }
    instance_.order.types.push_back(type);
    instance_.order.counts.push_back(static_cast<int>(n[7]));
  }

  const std::string stem_;
  Line expected_ = Line::kInstanceCount;
  long long instances_left_ = 0;
  long long types_left_ = 0;
  Instance instance_;
  bool sound_ = true;  ///< nothing of the instance was faulty so far
  bool lost_ = false;
  std::string fault_;
  std::vector<Instance> instances_;
};

}  // namespace

InstanceFile readBrFile(const std::string& path) {
  InstanceFile file;
  BrReader reader(stemOf(path));
  forEachLine(path, file.faults, [&](const std::string& line, int, std::vector<std::string>&) {
    if (reader.lost()) return;
    reader.take(line);
    reader.throwFault();
  });
  if (file.faults.empty() && !reader.complete()) {
    file.faults.push_back(path + ": ends in the middle of an instance");
  }
  file.instances = reader.takeInstances();
  return file;
}

}  // namespace mixed_palletizing::instances

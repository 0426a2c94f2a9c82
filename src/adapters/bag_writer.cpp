#include <utility>
#include <vector>

#include <mixed_palletizing/adapters/bag_writer.hpp>

namespace mixed_palletizing::adapters {
namespace {

std::mutex& bagMutex() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

BagWriter::BagWriter(const std::string& path) : path_(path), lock_(bagMutex()) {
  guarded([&] { bag_ = std::make_unique<rosbag::Bag>(path, rosbag::bagmode::Write); });
}

BagWriter::~BagWriter() {
  static auto* const broken = new std::vector<std::unique_ptr<rosbag::Bag>>();  // never destroyed
  if (bag_) broken->push_back(std::move(bag_));
}

void BagWriter::close() {
  guarded([&] { bag_->close(); });
  bag_.reset();
}

}  // namespace mixed_palletizing::adapters

// Bags that can fail to be written.
#pragma once

#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>

#include <rosbag/bag.h>

namespace mixed_palletizing::adapters {

/// Writes one bag; one at a time in a process, as rosbag's loader of plugins stands one thread only. Errors are
/// std::runtime_error "PATH: reason".
///
/// rosbag::Bag closes the file in its destructor, and what that throws on a full disk would end the program. So the
/// bag of a writer that was not closed is never destroyed.
class BagWriter {
 public:
  explicit BagWriter(const std::string& path);
  ~BagWriter();
  BagWriter(const BagWriter&) = delete;
  BagWriter& operator=(const BagWriter&) = delete;

  template <typename Message>
  void write(const std::string& topic, const ros::Time& stamp, const Message& message) {
    guarded([&] { bag_->write(topic, stamp, message); });
  }

  /// To be called after the last message.
  void close();

 private:
  template <typename Work>
  void guarded(const Work& work) const {
    try {
      work();
    } catch (const ros::Exception& error) {
      throw std::runtime_error(path_ + ": " + error.what());
    }
  }

  std::string path_;
  std::unique_lock<std::mutex> lock_;
  std::unique_ptr<rosbag::Bag> bag_;
};

}  // namespace mixed_palletizing::adapters

// Notices that the ROS master is away, or that another one came that does not know this node.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace mixed_palletizing::adapters {

enum class MasterState {
  kKnowsUs,
  kAway,    ///< does not answer
  kForgot,  ///< answers, but this node is not registered
};

/// Asks the master that this node was registered at.
MasterState askMaster();

/// roscpp registers a node once: at a master that was started anew its services and topics do not exist, and
/// nothing tells it. The watch says so in the log, and when the master is away, too. Thread of its own.
class MasterWatch {
 public:
  /// `on_forgotten` is called once, from the watch's thread, when the master has forgotten this node.
  explicit MasterWatch(std::function<void()> on_forgotten, std::function<MasterState()> ask = askMaster,
                       std::chrono::milliseconds period = std::chrono::seconds(1));
  ~MasterWatch();
  MasterWatch(const MasterWatch&) = delete;
  MasterWatch& operator=(const MasterWatch&) = delete;

  bool forgotten() const { return forgotten_; }

 private:
  void watch();
  MasterState askOr(MasterState before) const;
  void say(MasterState before, MasterState now) const;

  const std::function<void()> on_forgotten_;
  const std::function<MasterState()> ask_;
  const std::chrono::milliseconds period_;
  std::atomic<bool> forgotten_{false};
  std::mutex mutex_;  // guards ending_
  std::condition_variable ends_;
  bool ending_ = false;
  std::thread thread_;
};

/// Ends a node that nobody finds any more, so that a supervisor can start it again.
void endNode();

}  // namespace mixed_palletizing::adapters

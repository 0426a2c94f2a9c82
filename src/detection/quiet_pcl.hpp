// PCL reports expected outcomes on the console; this room reports them as values.
#pragma once

#include <mutex>

#include <pcl/console/print.h>

namespace mixed_palletizing::detection {

/// PCL prints nothing while one of these lives, in any thread.
class QuietPcl {
 public:
  QuietPcl() {
    const std::lock_guard<std::mutex> lock(state().mutex);
    if (state().alive++ > 0) return;
    state().before = pcl::console::getVerbosityLevel();
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  }
  ~QuietPcl() {
    const std::lock_guard<std::mutex> lock(state().mutex);
    if (--state().alive == 0) pcl::console::setVerbosityLevel(state().before);
  }
  QuietPcl(const QuietPcl&) = delete;
  QuietPcl& operator=(const QuietPcl&) = delete;

 private:
  /// The level is one for the whole process.
  struct State {
    std::mutex mutex;
    int alive = 0;
    pcl::console::VERBOSITY_LEVEL before = pcl::console::L_INFO;
  };
  static State& state() {
    static State the_one;
    return the_one;
  }
};

}  // namespace mixed_palletizing::detection

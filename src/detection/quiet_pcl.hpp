// PCL reports expected outcomes on the console; this room reports them as values.
#pragma once

#include <pcl/console/print.h>

namespace mixed_palletizing::detection {

/// PCL prints nothing while one of these lives.
class QuietPcl {
 public:
  QuietPcl() { pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); }
  ~QuietPcl() { pcl::console::setVerbosityLevel(before_); }
  QuietPcl(const QuietPcl&) = delete;
  QuietPcl& operator=(const QuietPcl&) = delete;

 private:
  pcl::console::VERBOSITY_LEVEL before_ = pcl::console::getVerbosityLevel();
};

}  // namespace mixed_palletizing::detection

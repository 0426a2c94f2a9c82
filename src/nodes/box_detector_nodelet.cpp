// The detector as a nodelet: shares the camera driver's process, so that clouds are passed by pointer.
#include <exception>
#include <memory>

#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.hpp>

#include <mixed_palletizing/adapters/detector_server.hpp>
#include <mixed_palletizing/adapters/master_watch.hpp>

namespace mixed_palletizing::nodes {

class BoxDetector : public nodelet::Nodelet {
 private:
  void onInit() override {
    try {
      server_ = std::make_unique<adapters::DetectorServer>(getPrivateNodeHandle());
      // Only says so: whether the manager ends is for the camera driver that lives in it.
      watch_ = std::make_unique<adapters::MasterWatch>([] {});
    } catch (const std::exception& error) {
      NODELET_FATAL_STREAM("the box detector does not start: " << error.what());
      throw;  // the manager answers the loader that it failed
    }
  }

  std::unique_ptr<adapters::DetectorServer> server_;
  std::unique_ptr<adapters::MasterWatch> watch_;
};

}  // namespace mixed_palletizing::nodes

PLUGINLIB_EXPORT_CLASS(mixed_palletizing::nodes::BoxDetector, nodelet::Nodelet)

// The simulated cell as a nodelet, where a camera driver's nodelet would be.
#include <exception>
#include <memory>

#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.hpp>

#include <mixed_palletizing/adapters/cell/simulator.hpp>

namespace mixed_palletizing::nodes {

class CellSimulator : public nodelet::Nodelet {
 private:
  void onInit() override {
    try {
      simulator_ = std::make_unique<cell::CellSimulator>(getNodeHandle(), getPrivateNodeHandle());
    } catch (const std::exception& error) {
      NODELET_FATAL_STREAM("the simulated cell does not start: " << error.what());
      throw;  // the manager answers the loader that it failed
    }
  }

  std::unique_ptr<cell::CellSimulator> simulator_;
};

}  // namespace mixed_palletizing::nodes

PLUGINLIB_EXPORT_CLASS(mixed_palletizing::nodes::CellSimulator, nodelet::Nodelet)

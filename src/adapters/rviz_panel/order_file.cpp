#include "order_file.hpp"

#include <stdexcept>
#include <vector>

#include <mixed_palletizing/adapters/start_request.hpp>
#include <mixed_palletizing/instances/files.hpp>

namespace mixed_palletizing::rviz_panel {

StartPalletRequest readOrder(const std::string& path, int index) {
  if (path.empty())
    throw std::invalid_argument("choose a file of orders first (generate_instances makes one)");
  const std::vector<instances::Instance> all = instances::readInstances(path);
  if (static_cast<std::size_t>(index) >= all.size()) {
    throw std::invalid_argument(path + ": has " + std::to_string(all.size()) + " orders, no number " +
                                std::to_string(index));
  }
  const instances::Instance& chosen = all[static_cast<std::size_t>(index)];
  return adapters::startRequest(chosen.name, chosen.order);
}

}  // namespace mixed_palletizing::rviz_panel

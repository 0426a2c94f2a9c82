// Order files of every format: any bytes give orders, faults or the documented errors. The first byte chooses the format.
#include <stdexcept>

#include <mixed_palletizing/instances/files.hpp>
#include <mixed_palletizing/instances/published_orders.hpp>

#include "scratch_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace instances = mixed_palletizing::instances;
  static const mixed_palletizing::fuzz::ScratchFolder folder;
  if (size == 0) return 0;
  const auto format = static_cast<instances::OrderFormat>(data[0] % 4);
  const std::string path = folder.write("orders", data + 1, size - 1);
  try {
    for (const instances::Instance& instance : instances::readOrders(path, format).instances) {
      // What was read must survive being written.
      instances::parseInstance(instances::formatInstance(instance));
    }
  } catch (const std::invalid_argument&) {
  } catch (const std::runtime_error&) {
  }
  return 0;
}

// Cloud files as a bag that looks like the camera driver's.
#include <iostream>
#include <string>
#include <vector>

#include <mixed_palletizing/adapters/cloud_bag.hpp>
#include <mixed_palletizing/adapters/command_line.hpp>

namespace adapters = mixed_palletizing::adapters;

int main(int argc, char** argv) {
  std::vector<std::string> clouds;
  std::string out;
  adapters::CloudBagOptions options;
  adapters::CommandLine line(
      "pcd_to_bag",
      "Writes organized clouds (PCD, PLY with a grid) as a bag in the layout of the camera driver, "
      "to be replayed with replay.launch.");
  line.required("clouds", &clouds, "cloud files, in the order of the bag");
  line.required("out", &out, "bag to write");
  line.option("topic", &options.topic, "topic of the clouds");
  line.option("frame_id", &options.frame_id, "optical frame of the camera");
  line.option("start_s", &options.start_s, "stamp of the first cloud [s]");
  line.option("period_s", &options.period_s, "time between clouds [s]");
  line.option("repeat", &options.repeat, "how often the list is written");
  return line.run(argc, argv, [&] {
    adapters::writeCloudBag(clouds, out, options);
    std::cout << out << ": " << clouds.size() * static_cast<std::size_t>(options.repeat) << " clouds on "
              << options.topic << "\n";
    return 0;
  });
}

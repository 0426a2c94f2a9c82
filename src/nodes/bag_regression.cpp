// Compares the detections in a bag with those of a golden file.
#include <cstdio>
#include <string>

#include <mixed_palletizing/adapters/bag_regression.hpp>
#include <mixed_palletizing/adapters/command_line.hpp>

namespace adapters = mixed_palletizing::adapters;

int main(int argc, char** argv) {
  adapters::BagRegression job;
  bool update = false;
  bool ignore_flags = false;
  adapters::CommandLine line(
      "bag_regression",
      "Replays a bag in process, without clocks, and compares what is detected with a golden file.");
  line.required("bag", &job.request.bag, "bag of clouds");
  line.required("golden", &job.golden, "golden file (JSON)");
  line.flag("update", &update, "write the golden file instead of comparing");
  line.option("topic", &job.request.topic, "of the clouds; not needed when only one topic holds clouds");
  line.option("calibration-cloud", &job.request.calibration_cloud,
              "cloud in which the base frame is looked for, instead of the bag's first");
  line.option("base", &job.request.base, "base frame: marker, floor, or a calibration file");
  line.option("params", &job.request.params, "parameter file of the detector node");
  line.option("position_tolerance_m", &job.tolerances.position_m, "of the centres");
  line.option("size_tolerance_m", &job.tolerances.size_m, "of length, width and height");
  line.option("yaw_tolerance_rad", &job.tolerances.yaw_rad, "of the yaw");
  line.option("base_tolerance_m", &job.tolerances.base_m, "of the base frame's origin");
  line.option("base_tolerance_rad", &job.tolerances.base_rad, "of the base frame's axes");
  line.flag("ignore_flags", &ignore_flags, "do not compare the flags of the boxes");
  line.option("pictures", &job.pictures,
              "folder for pictures of the changed clouds: golden in red, now in green");
  return line.run(argc, argv, [&] {
    job.tolerances.compare_flags = !ignore_flags;
    if (update) {
      const std::size_t clouds = adapters::updateGolden(job);
      std::printf("%s: %zu clouds\n", job.golden.c_str(), clouds);
      return 0;
    }
    const adapters::BagRegressionOutcome outcome = adapters::compareWithGolden(job);
    for (const std::string& text : outcome.lines) std::printf("%s\n", text.c_str());
    std::printf("%zu clouds, %zu differences\n", outcome.clouds, outcome.lines.size());
    return outcome.lines.empty() ? 0 : 1;
  });
}

// The base frame from simulated views of markers, against the truth.
#include <cmath>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <mixed_palletizing/adapters/command_line.hpp>
#include <mixed_palletizing/adapters/progress_line.hpp>
#include <mixed_palletizing/experiments/base_frame_measurement.hpp>

namespace adapters = mixed_palletizing::adapters;
namespace experiments = mixed_palletizing::experiments;

namespace {

struct Arguments {
  std::uint64_t count = 60;
  std::uint64_t seed = 1;
  double max_tilt_deg = 60.0;
  std::vector<std::string> dictionaries;
  std::string out;
};

int run(const Arguments& arguments) {
  experiments::BaseFrameViews views;
  views.max_tilt_rad = arguments.max_tilt_deg * M_PI / 180.0;
  if (!arguments.dictionaries.empty()) views.dictionaries = arguments.dictionaries;
  std::vector<experiments::BaseFrameRecord> records;
  adapters::ProgressLine progress(arguments.count, "views");
  for (std::uint64_t index = 0; index < arguments.count; ++index, progress.step()) {
    records.push_back(experiments::measureBaseFrame(views, arguments.seed, index));
  }
  if (!arguments.out.empty()) {
    std::ofstream file(arguments.out);
    for (const auto& record : records) file << experiments::recordJson(record) << '\n';
    file.close();
    if (!file) throw std::runtime_error(arguments.out + ": cannot be written");
  }
  for (const auto& record : records) {
    if (!record.found) std::cout << "view " << record.index << " not found: " << record.message << '\n';
  }
  for (const auto kind : {experiments::MarkerKind::kNormal, experiments::MarkerKind::kInverted,
                          experiments::MarkerKind::kBoard}) {
    std::cout << experiments::summaryText(toString(kind), experiments::summarize(records, kind)) << '\n';
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  adapters::CommandLine line(
      "measure_base_frame",
      "Finds the base frame in simulated views of markers and compares with the truth.");
  line.option("count", &arguments.count,
              "views: in turn of a marker, an inverted marker, a board of markers");
  line.option("seed", &arguments.seed, "of views and noise");
  line.option("max-tilt-deg", &arguments.max_tilt_deg, "of the optical axis against straight down");
  line.option("dictionaries", &arguments.dictionaries, "OpenCV's names; one is drawn for every view");
  line.option("out", &arguments.out, "file to write, one JSON object a view");
  return line.run(argc, argv, [&] { return run(arguments); });
}
